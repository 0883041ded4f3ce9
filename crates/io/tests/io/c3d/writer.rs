//! A small writer of C3D files, in the numbers of all machines.

/// The machine whose numbers are written.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) enum Machine {
    Intel,
    Dec,
    Mips,
}

pub(crate) const MACHINES: [Machine; 3] = [Machine::Intel, Machine::Dec, Machine::Mips];

/// What a parameter holds.
pub(crate) enum Value {
    /// Texts of one length each.
    Texts(Vec<String>),
    Words(Vec<u8>, Vec<i32>),
    Reals(Vec<u8>, Vec<f64>),
}

/// A channel: scale, offset and what it should say.
pub(crate) struct Signal {
    pub(crate) label: String,
    pub(crate) unit: String,
    pub(crate) scale: f64,
    pub(crate) offset: i32,
    pub(crate) samples: Vec<f64>,
}

/// A file to be.
pub(crate) struct File {
    pub(crate) machine: Machine,
    pub(crate) is_real: bool,
    /// What a number of a point is, where they are words.
    pub(crate) scale: f64,
    pub(crate) rate: f64,
    pub(crate) first: u16,
    /// Names and, frame by frame, places and residuals; none where hidden.
    pub(crate) labels: Vec<String>,
    pub(crate) frames: Vec<Vec<Option<[f64; 3]>>>,
    /// Samples of a frame.
    pub(crate) per_frame: usize,
    pub(crate) signals: Vec<Signal>,
    /// Group, name, value; in place of what is written anyway where that has the name.
    pub(crate) parameters: Vec<(&'static str, &'static str, Value)>,
}

impl Machine {
    fn word(self, value: u16, out: &mut Vec<u8>) {
        match self {
            Self::Mips => out.extend(value.to_be_bytes()),
            _ => out.extend(value.to_le_bytes()),
        }
    }

    fn real(self, value: f64, out: &mut Vec<u8>) {
        let bits = (value as f32).to_bits();
        match self {
            Self::Intel => out.extend(bits.to_le_bytes()),
            Self::Mips => out.extend(bits.to_be_bytes()),
            Self::Dec => {
                let bits = if bits << 1 == 0 { 0 } else { bits + (2 << 23) };
                let [a, b, c, d] = bits.to_le_bytes();
                out.extend([c, d, a, b]);
            }
        }
    }
}

impl File {
    /// Its bytes.
    pub(crate) fn write(&self) -> Vec<u8> {
        let mut parameters = self.parameter_section(0);
        let block = 2 + parameters.len() / 512;
        parameters = self.parameter_section(block);
        let mut out = self.header(block);
        out.extend(parameters);
        for (frame, points) in self.frames.iter().enumerate() {
            for point in points {
                let [x, y, z, rest] = match point {
                    // Cameras 1 and 2 in the high byte, a residual of 3 in the low one.
                    Some([x, y, z]) => [*x, *y, *z, f64::from(0x0303)],
                    None => [0.0, 0.0, 0.0, -1.0],
                };
                let divisor = if self.is_real { 1.0 } else { self.scale };
                for value in [x / divisor, y / divisor, z / divisor, rest] {
                    self.number(value, &mut out);
                }
            }
            for sample in 0..self.per_frame {
                for signal in &self.signals {
                    let value = signal.samples[frame * self.per_frame + sample];
                    self.number(value / signal.scale + f64::from(signal.offset), &mut out);
                }
            }
        }
        out
    }

    fn number(&self, value: f64, out: &mut Vec<u8>) {
        if self.is_real {
            self.machine.real(value, out);
        } else {
            let value = value.round();
            assert!(value.abs() < 32768.0, "{value} is no word");
            self.machine.word(value as i16 as u16, out);
        }
    }

    fn point_scale(&self) -> f64 {
        if self.is_real { -self.scale } else { self.scale }
    }

    fn header(&self, block: usize) -> Vec<u8> {
        let mut out = vec![2, 0x50];
        let mut word = |value: usize| self.machine.word(value as u16, &mut out);
        word(self.labels.len());
        word(self.signals.len() * self.per_frame);
        word(usize::from(self.first));
        word(usize::from(self.first) + self.frames.len() - 1);
        word(10);
        self.machine.real(self.point_scale(), &mut out);
        self.machine.word(block as u16, &mut out);
        self.machine.word(self.per_frame as u16, &mut out);
        self.machine.real(self.rate, &mut out);
        out.resize(512, 0);
        out
    }

    /// The parameters, filled up to whole blocks; the frames begin in `block`.
    fn parameter_section(&self, block: usize) -> Vec<u8> {
        let texts =
            |of: fn(&Signal) -> &String| Value::Texts(self.signals.iter().map(|s| of(s).clone()).collect());
        let one = |value: f64| Value::Reals(vec![], vec![value]);
        let word = |value: usize| Value::Words(vec![], vec![value as i32]);
        let count = vec![self.signals.len() as u8];
        let mut all = vec![
            ("POINT", "USED", word(self.labels.len())),
            ("POINT", "SCALE", one(self.point_scale())),
            ("POINT", "RATE", one(self.rate)),
            ("POINT", "DATA_START", word(block)),
            ("POINT", "FRAMES", word(self.frames.len())),
            ("POINT", "LABELS", Value::Texts(self.labels.clone())),
            ("POINT", "UNITS", Value::Texts(vec!["mm".to_owned()])),
            ("ANALOG", "USED", word(self.signals.len())),
            ("ANALOG", "LABELS", texts(|signal| &signal.label)),
            ("ANALOG", "UNITS", texts(|signal| &signal.unit)),
            ("ANALOG", "GEN_SCALE", one(1.0)),
            ("ANALOG", "RATE", one(self.rate * self.per_frame as f64)),
            ("ANALOG", "SCALE", Value::Reals(count.clone(), self.signals.iter().map(|s| s.scale).collect())),
            ("ANALOG", "OFFSET", Value::Words(count, self.signals.iter().map(|s| s.offset).collect())),
        ];
        all.retain(|(group, name, _)| !self.parameters.iter().any(|(g, n, _)| (g, n) == (group, name)));
        let mut groups: Vec<&str> = Vec::new();
        for (group, ..) in all.iter().chain(&self.parameters) {
            if !groups.contains(group) {
                groups.push(group);
            }
        }
        let mut out = vec![1, 0x50, 0, [84, 85, 86][self.machine as usize]];
        for (at, group) in groups.iter().enumerate() {
            out.extend([group.len() as u8, (-(at as i8) - 1) as u8]);
            out.extend(group.as_bytes());
            self.machine.word(3, &mut out);
            out.push(0);
        }
        for (group, name, value) in all.iter().chain(&self.parameters) {
            let id = groups.iter().position(|known| known == group).map_or(0, |at| at as u8 + 1);
            self.parameter(id, name, value, &mut out);
        }
        out.extend([0, 0]);
        out.resize(out.len().div_ceil(512) * 512, 0);
        out[2] = (out.len() / 512) as u8;
        out
    }

    fn parameter(&self, id: u8, name: &str, value: &Value, out: &mut Vec<u8>) {
        let (kind, sizes, mut data) = match value {
            Value::Texts(texts) => {
                let width = texts.iter().map(String::len).max().unwrap_or(0).max(1);
                let data: Vec<u8> =
                    texts.iter().flat_map(|text| format!("{text:width$}").into_bytes()).collect();
                (-1_i8, vec![width as u8, texts.len() as u8], data)
            }
            Value::Words(sizes, values) => {
                let mut data = Vec::new();
                for value in values {
                    self.machine.word(*value as u16, &mut data);
                }
                (2, sizes.clone(), data)
            }
            Value::Reals(sizes, values) => {
                let mut data = Vec::new();
                for value in values {
                    self.machine.real(*value, &mut data);
                }
                (4, sizes.clone(), data)
            }
        };
        out.extend([name.len() as u8, id]);
        out.extend(name.as_bytes());
        self.machine.word((2 + 2 + sizes.len() + data.len() + 1) as u16, out);
        out.extend([kind as u8, sizes.len() as u8]);
        out.extend(sizes);
        out.append(&mut data);
        out.push(0);
    }
}
