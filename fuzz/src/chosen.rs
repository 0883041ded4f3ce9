//! Numbers and choices that the bytes of an input make.

/// Reads an input from its beginning; after its end all is zero.
pub struct Chosen<'a>(pub &'a [u8]);

/// Numbers that formulas trip over.
const HARD: [f64; 16] = [
    0.0,
    -0.0,
    1.0,
    -1.0,
    1e-8,
    1e-17,
    1e-300,
    5e-324,
    1e8,
    1e17,
    1e154,
    f64::MAX,
    f64::INFINITY,
    f64::NEG_INFINITY,
    f64::NAN,
    std::f64::consts::PI,
];

impl<'a> Chosen<'a> {
    /// The next byte.
    pub fn byte(&mut self) -> u8 {
        let Some((first, rest)) = self.0.split_first() else { return 0 };
        self.0 = rest;
        *first
    }

    /// Whether there is more.
    pub fn is_over(&self) -> bool {
        self.0.is_empty()
    }

    /// A number below `end`.
    pub fn below(&mut self, end: usize) -> usize {
        usize::from(self.byte()) % end
    }

    /// A number of a size as bodies have, in steps that are fine near zero: up to 8 with either sign.
    pub fn number(&mut self) -> f64 {
        let x = f64::from(i16::from_le_bytes([self.byte(), self.byte()])) / 32_768.0;
        8.0 * x * x * x
    }

    /// The same, but that one in eight is one that formulas trip over.
    pub fn any(&mut self) -> f64 {
        if self.below(8) == 0 { HARD[self.below(HARD.len())] } else { self.number() }
    }

    /// Some text, of what may stand in a name and means something to pages, tables and terminals.
    pub fn name(&mut self) -> String {
        const PIECES: [&str; 20] = [
            "<zq",
            "</script>",
            "<!--",
            "&",
            "\"",
            "'",
            "\\",
            "{{",
            "}}",
            "\u{1b}[31m",
            "\u{9b}",
            "\u{202e}",
            "\u{0}",
            "\n",
            "\r",
            "é",
            ",",
            "]]>",
            "a",
            "\u{1f600}",
        ];
        (0..1 + self.below(5)).map(|_| PIECES[self.below(PIECES.len())]).collect()
    }
}
