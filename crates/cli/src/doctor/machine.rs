//! What the program and its machine are, as far as answers may depend on it.

use serde::Serialize;
use std::io::Write;
use std::num::NonZero;
use std::thread::available_parallelism;

/// The program and its machine.
#[derive(Debug, Serialize)]
pub(super) struct Machine {
    version: &'static str,
    target: &'static str,
    compiler: &'static str,
    /// Optimised, as releases are.
    optimised: bool,
    features: Vec<&'static str>,
    /// Whether the studio's page is in the program.
    studio: bool,
    system: &'static str,
    architecture: &'static str,
    cores: Option<usize>,
    vector_instructions: Vec<&'static str>,
}

impl Machine {
    pub(super) fn here() -> Self {
        let features = [("parquet", cfg!(feature = "parquet")), ("stiff", cfg!(feature = "stiff"))];
        Self {
            version: env!("CARGO_PKG_VERSION"),
            target: env!("SOLARIS_TARGET"),
            compiler: env!("SOLARIS_COMPILER"),
            optimised: !cfg!(debug_assertions),
            features: features.into_iter().filter(|(_, is_in)| *is_in).map(|(name, _)| name).collect(),
            studio: cfg!(studio),
            system: std::env::consts::OS,
            architecture: std::env::consts::ARCH,
            cores: available_parallelism().ok().map(NonZero::get),
            vector_instructions: vector_instructions(),
        }
    }

    pub(super) fn write(&self, out: &mut dyn Write) -> std::io::Result<()> {
        writeln!(out, "solaris {}\n", self.version)?;
        let listed = |names: &[&str]| if names.is_empty() { "none".to_owned() } else { names.join(", ") };
        let mut row = |what: &str, value: String| writeln!(out, "  {what:<24}{value}");
        let how = if self.optimised { "release" } else { "debug" };
        row("built for", format!("{}, {how}, by {}", self.target, self.compiler))?;
        row("features", listed(&self.features))?;
        row("studio", if self.studio { "in the program" } else { "not in the program" }.to_owned())?;
        row("system", format!("{}, {}", self.system, self.architecture))?;
        row("cores", self.cores.map_or_else(|| "unknown".to_owned(), |cores| cores.to_string()))?;
        row("vector instructions", listed(&self.vector_instructions))
    }
}

/// Those that the kernel asks the machine for (`solaris-dynamics`, `wide` and `batch`), of which it takes the best.
#[cfg(target_arch = "x86_64")]
fn vector_instructions() -> Vec<&'static str> {
    use std::arch::is_x86_feature_detected as has;
    let all = [
        ("AVX2", has!("avx2")),
        ("FMA", has!("fma")),
        ("AVX-512", has!("avx512f") && has!("avx512dq") && has!("avx512vl")),
    ];
    all.into_iter().filter(|(_, is_there)| *is_there).map(|(name, _)| name).collect()
}

#[cfg(not(target_arch = "x86_64"))]
fn vector_instructions() -> Vec<&'static str> {
    Vec::new()
}
