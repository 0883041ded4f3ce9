//! MuJoCo's side: the driver in C, and the method apart in Python.

use super::bodies::Scene;
use super::points::{End, Point, Series};
use crate::mjcf;
use crate::workspace::root;
use std::fmt::Write as _;
use std::fs;
use std::io::Write;
use std::path::{Path, PathBuf};
use std::process::{Command, Stdio};

/// What runs Python where the environment does not say: it has the packages mujoco, numpy and scipy.
const PYTHON: &str = "python3";

/// Where the package is, with the library's file.
const WHERE: &str = "import mujoco, scipy, glob, os; d = os.path.dirname(mujoco.__file__); print(d); print(glob.glob(d + '/libmujoco.so*')[0]); print(scipy.__version__)";

/// The tolerance of the method apart.
const TOLERANCE: f64 = 1e-12;

/// Steps of a run.
const STEPS: [u32; 16] = [2, 4, 8, 16, 32, 64, 128, 256, 512, 1024, 2048, 4096, 8192, 16_384, 32_768, 65_536];

/// What resists in a contact on the hardest ground: all but this part of it.
const SOFT: f64 = 1e-4;

/// A MuJoCo that is at hand.
pub(super) struct MuJoCo {
    python: PathBuf,
    driver: PathBuf,
    folder: PathBuf,
    pub(super) version: String,
    pub(super) scipy: String,
}

impl MuJoCo {
    /// Builds the driver; nothing where there is no package or no compiler, which is said.
    pub(super) fn find() -> Result<Option<Self>, String> {
        let skipped = |why: &str| {
            eprintln!("report: beside MuJoCo: skipped, {why}");
            Ok(None)
        };
        let python = PathBuf::from(std::env::var_os("PYTHON").unwrap_or_else(|| PYTHON.into()));
        let said = Command::new(&python).args(["-c", WHERE]).output();
        let Some(said) = said.ok().filter(|said| said.status.success()) else {
            return skipped(&format!(
                "{} has no packages mujoco and scipy (PYTHON names another)",
                python.display()
            ));
        };
        let said = String::from_utf8_lossy(&said.stdout).into_owned();
        let Some([package, library, scipy]) = said.lines().collect::<Vec<_>>().first_chunk::<3>().copied()
        else {
            return skipped("the package mujoco has no library");
        };
        let folder = root().join("target/lab/stepping");
        fs::create_dir_all(&folder).map_err(|error| format!("{}: {error}", folder.display()))?;
        let driver = folder.join("mujoco_steps");
        let mut compile = Command::new(std::env::var_os("CC").unwrap_or_else(|| "cc".into()));
        compile.args(["-O2", "-o"]).arg(&driver).arg(root().join("lab/peers/mujoco_steps.c"));
        compile.arg(format!("-I{package}/include")).arg(library).arg(format!("-Wl,-rpath,{package}"));
        match compile.status() {
            Ok(status) if status.success() => {}
            _ => return skipped("its driver does not compile (CC names another compiler)"),
        }
        let lines = talk(Command::new(&driver), "")?;
        let version =
            lines.first().and_then(|line| line.strip_prefix("version ")).unwrap_or_default().to_owned();
        Ok(Some(Self { python, driver, folder, version, scipy: scipy.to_owned() }))
    }

    /// The scene's model, in a file.
    pub(super) fn model(&self, scene: &Scene) -> Result<PathBuf, String> {
        let simulation = &scene.simulation;
        let path = self.folder.join(format!("{}.xml", simulation.figure().name().replace(' ', "_")));
        fs::write(&path, mjcf::text(simulation)).map_err(|error| format!("{}: {error}", path.display()))?;
        Ok(path)
    }

    /// The end of a motion in the air by a method that is neither ours nor MuJoCo's, on MuJoCo's accelerations.
    pub(super) fn reference(&self, scene: &Scene, model: &Path) -> Result<End, String> {
        let mut python = Command::new(&self.python);
        python.arg(root().join("lab/peers/mujoco_reference.py"));
        let lines = talk(python, &format!("{}solve {TOLERANCE}\n", begun(scene, model, false)))?;
        ends(&lines, scene)?.pop().map(|(_, end)| end).ok_or_else(|| format!("{}: no reference", scene.name))
    }

    /// Every integrator at every step.
    pub(super) fn series(&self, scene: &Scene, model: &Path, answer: &End) -> Result<Vec<Series>, String> {
        let grounded = scene.simulation.grounded().is_some();
        let mut all = vec![
            ("MuJoCo: RK4", "rk4", true),
            ("MuJoCo: implicit", "implicit", true),
            ("MuJoCo: implicitfast", "implicitfast", true),
            ("MuJoCo: Euler", "euler", true),
        ];
        if grounded {
            all.push(("MuJoCo: discrete", "discrete", true));
            all.push(("MuJoCo: implicitfast, contacts as shipped", "implicitfast", false));
        }
        let one = |(name, integrator, is_hard): (&'static str, &str, bool)| {
            let mut text = begun(scene, model, scene.with_slip.is_some());
            for count in STEPS {
                let step = scene.duration / f64::from(count);
                // A contact that is harder than two steps is softened by MuJoCo itself.
                let constant = if grounded && is_hard { 2.0 * step } else { 0.0 };
                let _ = writeln!(text, "run {integrator} {step:e} {constant:e} {}", 1.0 - SOFT);
            }
            let ends = ends(&talk(Command::new(&self.driver), &text)?, scene)?;
            let point = |(count, (seconds, end)): (&u32, (f64, End))| {
                let setting = format!("{:.1e} s", scene.duration / f64::from(*count));
                Point { setting, count: f64::from(*count), seconds, error: scene.error(&end, answer) }
            };
            Ok(Series { name, is_ours: false, points: STEPS.iter().zip(ends).map(point).collect() })
        };
        all.into_iter().map(one).collect()
    }
}

/// Model and beginning of a scene, as both programs read them.
fn begun(scene: &Scene, model: &Path, settles: bool) -> String {
    let (q, v) = scene.simulation.state();
    let order = mjcf::order(scene.simulation.figure());
    // What slides begins on the ground, and sinks as deep as MuJoCo's lets it.
    let words = |numbers: &[f64], scale: f64| {
        order.iter().map(|&i| format!("{:e}", scale * numbers[i])).collect::<Vec<_>>().join(" ")
    };
    let settle = if settles { 1.0 } else { 0.0 };
    format!(
        "model {}\nduration {:e}\nsettle {settle:e}\nq {}\nv {}\n",
        model.display(),
        scene.duration,
        words(q, if settles { 0.0 } else { 1.0 }),
        words(v, 1.0)
    )
}

/// Times and ends of what a program said.
fn ends(lines: &[String], scene: &Scene) -> Result<Vec<(f64, End)>, String> {
    let order = mjcf::order(scene.simulation.figure());
    let nq = order.len();
    let sorted = |numbers: &[f64]| {
        let mut own = vec![0.0; nq];
        order.iter().zip(numbers).for_each(|(&i, x)| own[i] = *x);
        own
    };
    let read = |line: &String| {
        let rest = line.strip_prefix("result ")?;
        let numbers: Option<Vec<f64>> = rest.split(' ').map(|word| word.parse().ok()).collect();
        let mut numbers = numbers.filter(|numbers| numbers.len() >= 2 * nq)?;
        let v = numbers.split_off(numbers.len() - nq);
        let q = numbers.split_off(numbers.len() - nq);
        Some((numbers.first().copied().unwrap_or(0.0), (sorted(&q), sorted(&v))))
    };
    let results = lines.iter().filter(|line| line.starts_with("result "));
    results.map(|line| read(line).ok_or_else(|| format!("{}: no result: {line}", scene.name))).collect()
}

/// What a program answers to a text.
fn talk(mut command: Command, text: &str) -> Result<Vec<String>, String> {
    let name = command.get_program().to_string_lossy().into_owned();
    let failed = |error: &dyn std::fmt::Display| format!("{name}: {error}");
    let mut child =
        command.stdin(Stdio::piped()).stdout(Stdio::piped()).spawn().map_err(|error| failed(&error))?;
    if let Some(mut stdin) = child.stdin.take() {
        stdin.write_all(text.as_bytes()).map_err(|error| failed(&error))?;
    }
    let said = child.wait_with_output().map_err(|error| failed(&error))?;
    if !said.status.success() {
        return Err(failed(&said.status));
    }
    Ok(String::from_utf8_lossy(&said.stdout).lines().map(str::to_owned).collect())
}
