//! A small BVH reader that shares nothing with the writer: it goes by the words of the file alone.

/// A node of the hierarchy.
pub(crate) struct Node {
    pub(crate) name: String,
    parent: Option<usize>,
    offset: [f64; 3],
    /// Channel words in the file's order.
    pub(crate) channels: Vec<String>,
    /// Offset of the end site.
    pub(crate) end: Option<[f64; 3]>,
}

/// A parsed file.
pub(crate) struct Bvh {
    pub(crate) nodes: Vec<Node>,
    pub(crate) frame_time: f64,
    pub(crate) frames: Vec<Vec<f64>>,
}

type Matrix = [[f64; 4]; 4];

pub(crate) fn parse(text: &str) -> Bvh {
    let (hierarchy, motion) = text.split_once("MOTION").expect("two parts");
    let mut words = hierarchy.split_whitespace();
    assert_eq!(words.next(), Some("HIERARCHY"));
    let (mut nodes, mut open, mut in_end) = (Vec::<Node>::new(), Vec::<usize>::new(), false);
    while let Some(word) = words.next() {
        match word {
            "ROOT" | "JOINT" => {
                assert_eq!(word == "ROOT", nodes.is_empty(), "one root, first");
                let name = words.next().expect("a name").to_owned();
                let parent = open.last().copied();
                nodes.push(Node { name, parent, offset: [0.0; 3], channels: Vec::new(), end: None });
                assert_eq!(words.next(), Some("{"));
                open.push(nodes.len() - 1);
            }
            "End" => {
                assert_eq!((words.next(), words.next()), (Some("Site"), Some("{")));
                in_end = true;
            }
            "OFFSET" => {
                let offset: [f64; 3] = std::array::from_fn(|_| number(words.next().expect("three numbers")));
                let node = &mut nodes[*open.last().expect("inside a joint")];
                if in_end { node.end = Some(offset) } else { node.offset = offset }
            }
            "CHANNELS" => {
                let count: usize = words.next().and_then(|n| n.parse().ok()).expect("a count");
                let node = &mut nodes[*open.last().expect("inside a joint")];
                node.channels = (0..count).map(|_| words.next().expect("a channel").to_owned()).collect();
            }
            "}" if in_end => in_end = false,
            "}" => drop(open.pop().expect("an open joint")),
            other => panic!("unknown word {other}"),
        }
    }
    assert!(open.is_empty(), "every brace closes");
    frames(nodes, motion)
}

fn frames(nodes: Vec<Node>, motion: &str) -> Bvh {
    let mut lines = motion.trim_start().lines();
    let count = lines.next().and_then(|line| line.strip_prefix("Frames: ")).expect("Frames");
    let time = lines.next().and_then(|line| line.strip_prefix("Frame Time: ")).expect("Frame Time");
    let frames: Vec<Vec<f64>> = lines.map(|line| line.split_whitespace().map(number).collect()).collect();
    assert_eq!(frames.len().to_string(), count);
    let width: usize = nodes.iter().map(|node| node.channels.len()).sum();
    assert!(frames.iter().all(|frame| frame.len() == width), "a number a channel");
    Bvh { nodes, frame_time: number(time), frames }
}

fn number(word: &str) -> f64 {
    word.parse().expect("a number")
}

impl Bvh {
    /// World positions in the file's units of every node, and of its end site where it has one.
    pub(crate) fn positions(&self, frame: usize) -> Vec<([f64; 3], Option<[f64; 3]>)> {
        let mut values = self.frames[frame].iter();
        let mut worlds: Vec<Matrix> = Vec::new();
        for node in &self.nodes {
            let mut world = node.parent.map_or_else(|| shift([0.0; 3]), |parent| worlds[parent]);
            // A position is in place of the offset, wherever its channel stands, as most tools read it.
            let (mut at, mut turned) = (node.offset, shift([0.0; 3]));
            for channel in &node.channels {
                let value = *values.next().expect("a number a channel");
                let axis = channel.bytes().next().map_or(9, |letter| usize::from(letter - b'X'));
                match &channel[1..] {
                    "position" => at[axis] = value,
                    "rotation" => turned = product(&turned, &turn(axis, value.to_radians())),
                    other => panic!("unknown channel {other}"),
                }
            }
            world = product(&product(&world, &shift(at)), &turned);
            worlds.push(world);
        }
        let place = |m: &Matrix| [m[0][3], m[1][3], m[2][3]];
        let ends = self.nodes.iter().map(|node| node.end);
        worlds
            .iter()
            .zip(ends)
            .map(|(w, end)| (place(w), end.map(|end| place(&product(w, &shift(end))))))
            .collect()
    }

    /// All values of one channel, frame by frame.
    pub(crate) fn channel(&self, node: &str, channel: &str) -> Vec<f64> {
        let all =
            self.nodes.iter().flat_map(|n| n.channels.iter().map(move |c| (n.name.as_str(), c.as_str())));
        let place = all.into_iter().position(|name| name == (node, channel)).expect("the channel");
        self.frames.iter().map(|frame| frame[place]).collect()
    }
}

fn shift(by: [f64; 3]) -> Matrix {
    [[1.0, 0.0, 0.0, by[0]], [0.0, 1.0, 0.0, by[1]], [0.0, 0.0, 1.0, by[2]], [0.0, 0.0, 0.0, 1.0]]
}

fn turn(axis: usize, angle: f64) -> Matrix {
    let (s, c) = angle.sin_cos();
    let (j, k) = ((axis + 1) % 3, (axis + 2) % 3);
    let mut matrix = shift([0.0; 3]);
    (matrix[j][j], matrix[j][k], matrix[k][j], matrix[k][k]) = (c, -s, s, c);
    matrix
}

fn product(a: &Matrix, b: &Matrix) -> Matrix {
    std::array::from_fn(|i| std::array::from_fn(|j| (0..4).map(|k| a[i][k] * b[k][j]).sum()))
}
