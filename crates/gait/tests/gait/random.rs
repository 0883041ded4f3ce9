//! Random numbers that are the same in every run and on every machine.

/// Equally distributed numbers from 0 to 1.
pub(crate) struct Random(pub(crate) u64);

impl Random {
    pub(crate) fn next(&mut self) -> f64 {
        self.0 = self.0.wrapping_mul(6_364_136_223_846_793_005).wrapping_add(1_442_695_040_888_963_407);
        (self.0 >> 33) as f64 / f64::from(1_u32 << 31)
    }

    pub(crate) fn within(&mut self, from: f64, to: f64) -> f64 {
        from + (to - from) * self.next()
    }

    pub(crate) fn often(&mut self, part: f64) -> bool {
        self.next() < part
    }

    /// One of so many.
    pub(crate) fn pick(&mut self, count: usize) -> usize {
        (self.next() * count as f64) as usize
    }
}
