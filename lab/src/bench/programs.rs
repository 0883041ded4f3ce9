//! The peers: their packages, programs and what those say.

use super::figures::{GRAVITY, Subject};
use super::text;
use crate::mjcf;
use crate::peers::states;
use crate::workspace::root;
use solaris_modes::Simulation;
use std::ffi::OsStr;
use std::fs;
use std::path::{Path, PathBuf};
use std::process::{Command, Stdio};

/// For Pinocchio's headers: Boost's lists are too short for its joints.
const PINOCCHIO: [&str; 7] = [
    "-DNDEBUG",
    "-DEIGEN_NO_DEBUG",
    "-DBOOST_MPL_CFG_NO_PREPROCESSED_HEADERS",
    "-DBOOST_MPL_LIMIT_LIST_SIZE=30",
    "-DBOOST_MPL_LIMIT_VECTOR_SIZE=30",
    "-DBOOST_FUSION_INVOKE_MAX_ARITY=12",
    "-w",
];
/// What every program is compiled with: clang, for this processor.
pub(super) const FLAGS: [&str; 3] = ["-O3", "-mcpu=native", "-std=c++17"];
/// The most degrees of freedom that Pinocchio has room for: its scratch memory grows with the third power.
const MOST: usize = 300;
/// How far forces may be from ours, of the greatest one.
const AGREES: f64 = 1e-10;

/// A program that times the operations of one engine.
pub(super) struct Program {
    pub(super) name: &'static str,
    path: PathBuf,
    model: fn(&Subject) -> Option<(String, &'static str)>,
}

/// What is at hand, in a folder of its own.
pub(super) struct Peers {
    folder: PathBuf,
    pub(super) packages: String,
    pub(super) versions: String,
    pub(super) programs: Vec<Program>,
}

impl Peers {
    /// Installs packages and compiles programs, what of them is not there yet.
    pub(super) fn prepare() -> Result<Self, String> {
        let folder = root().join("target/peers");
        fs::create_dir_all(&folder).map_err(|error| format!("{}: {error}", folder.display()))?;
        let python = folder.join("venv/bin/python");
        if !python.exists() {
            eprintln!("bench: a Python of its own, in {}", folder.display());
            run("python3", [OsStr::new("-m"), "venv".as_ref(), folder.join("venv").as_ref()])?;
        }
        eprintln!("bench: the packages of lab/peers/requirements.txt");
        let wanted = root().join("lab/peers/requirements.txt");
        let install =
            ["-m", "pip", "install", "--quiet", "--disable-pip-version-check", "-r"].map(OsStr::new);
        run(&python, install.into_iter().chain([wanted.as_ref()]))?;
        let packages = said(&python, &["-c", "import sysconfig; print(sysconfig.get_paths()['purelib'])"])?;
        let packages = packages.trim().to_owned();
        let version = "import importlib.metadata as m; print('Pinocchio ' + m.version('pin') + ', MuJoCo ' + m.version('mujoco') + \
                       ', clang of ziglang ' + m.version('ziglang'))";
        let versions = format!("{}, dynibo 0.5.3", said(&python, &["-c", version])?.trim());
        let mut peers = Self { folder, packages, versions, programs: Vec::new() };
        peers.compile(&python)?;
        Ok(peers)
    }

    fn compile(&mut self, python: &Path) -> Result<(), String> {
        let (packages, prefix) = (&self.packages, format!("{}/cmeel.prefix/include", self.packages));
        let library = fs::read_dir(format!("{packages}/mujoco"))
            .map_err(|error| format!("{packages}/mujoco: {error}"))?
            .filter_map(|entry| Some(entry.ok()?.path()))
            .find(|path| path.to_string_lossy().contains("libmujoco.so"))
            .ok_or_else(|| format!("{packages}/mujoco has no library"))?;
        let pinocchio = PINOCCHIO.iter().map(|flag| (*flag).to_owned());
        let pinocchio = pinocchio.chain([format!("-I{prefix}"), format!("-I{prefix}/eigen3")]);
        let mujoco = [
            format!("-I{packages}/mujoco/include"),
            library.display().to_string(),
            format!("-Wl,-rpath,{packages}/mujoco"),
        ];
        for (name, flags) in [("pinocchio", pinocchio.collect()), ("mujoco_kernel", mujoco.to_vec())] {
            let (source, target) = (root().join(format!("lab/peers/{name}.cpp")), self.folder.join(name));
            if is_newer(&target, &[&source, &root().join("lab/peers/timing.h")]) {
                continue;
            }
            eprintln!(
                "bench: compiling {name}.cpp{}",
                if name == "pinocchio" { ": some minutes" } else { "" }
            );
            let mut compile = Command::new(python);
            compile
                .args(["-m", "ziglang", "c++"])
                .args(FLAGS)
                .args(flags)
                .arg(&source)
                .arg("-o")
                .arg(&target);
            finish(&mut compile)?;
        }
        eprintln!("bench: dynibo");
        let manifest = root().join("lab/peers/dynibo/Cargo.toml");
        let mut build = Command::new(std::env::var_os("CARGO").unwrap_or_else(|| "cargo".into()));
        build.args(["build", "--release", "--quiet", "--manifest-path"]).arg(manifest);
        finish(
            build.env("CARGO_TARGET_DIR", self.folder.join("dynibo")).env("RUSTFLAGS", "-Ctarget-cpu=native"),
        )?;
        self.programs = vec![
            Program {
                name: "Pinocchio",
                path: self.folder.join("pinocchio"),
                model: |subject| {
                    let text = text::flat(&subject.name, &subject.figure, true);
                    (subject.figure.layout().nv() <= MOST).then_some((text, "txt"))
                },
            },
            Program {
                name: "MuJoCo",
                path: self.folder.join("mujoco_kernel"),
                // Its readers go no deeper.
                model: |subject| {
                    let text = mjcf::text(&Simulation::new(&subject.figure, GRAVITY));
                    (is_plain(subject) && subject.figure.layout().nv() <= MOST).then_some((text, "xml"))
                },
            },
            Program {
                name: "dynibo",
                path: self.folder.join("dynibo/release/solaris-beside-dynibo"),
                model: |subject| {
                    is_plain(subject).then(|| (text::urdf(&subject.name, &subject.figure), "urdf"))
                },
            },
        ];
        Ok(())
    }

    /// Writes what the programs read of a figure.
    pub(super) fn write(&self, subject: &Subject) -> Result<(), String> {
        subject.states.write(&self.folder.join(&subject.name))?;
        for program in &self.programs {
            if let Some((text, ending)) = (program.model)(subject) {
                let path = self.folder.join(format!("{}.{ending}", subject.name));
                fs::write(&path, text).map_err(|error| format!("{}: {error}", path.display()))?;
            }
        }
        Ok(())
    }

    /// Operations and their times (ns, the least of one run); nothing where the program does not know such figures.
    pub(super) fn time(
        &self,
        program: &Program,
        subject: &Subject,
        block: f64,
        rounds: usize,
    ) -> Result<Vec<(String, f64)>, String> {
        let Some((_, ending)) = (program.model)(subject) else { return Ok(Vec::new()) };
        let prefix = self.folder.join(&subject.name);
        let out = self.folder.join(format!("{}_{}", subject.name, program.name));
        let mut command = Command::new(&program.path);
        command.arg(prefix.with_extension(ending)).arg(&prefix).arg(&out);
        command.args([block.to_string(), rounds.to_string()]);
        let text = finish(&mut command)?;
        let line = |line: &str| {
            let words: Vec<&str> = line.split('\t').collect();
            let ["RESULT", operation, median, _] = words[..] else { return None };
            Some((operation.to_owned(), median.parse().ok()?))
        };
        Ok(text.lines().filter_map(line).collect())
    }

    /// How far the forces and accelerations that a program found are from ours, of the greatest one of each.
    pub(super) fn disagreement(
        &self,
        program: &Program,
        subject: &Subject,
        ours: &[Vec<f64>; 2],
    ) -> Result<Option<[f64; 2]>, String> {
        if (program.model)(subject).is_none() {
            return Ok(None);
        }
        let nv = subject.figure.layout().nv();
        let mut worst = [0.0; 2];
        for ((what, ours), worst) in ["rnea", "aba"].iter().zip(ours).zip(&mut worst) {
            let path = self.folder.join(format!("{}_{}_{what}.f64", subject.name, program.name));
            let found = states::read(&path, nv)?;
            let greatest = ours.iter().fold(0.0_f64, |most, x| most.max(x.abs()));
            *worst = ours.iter().zip(&found).fold(0.0_f64, |most, (a, b)| most.max((a - b).abs())) / greatest;
        }
        if worst[0] > AGREES {
            let (program, subject) = (program.name, &subject.name);
            return Err(format!(
                "{program} finds other forces for {subject}: {:e} of the greatest",
                worst[0]
            ));
        }
        Ok(Some(worst))
    }
}

/// Whether the figure has hinges and slides alone, in the order in which MuJoCo has them.
fn is_plain(subject: &Subject) -> bool {
    let figure = &subject.figure;
    figure.links().iter().all(|link| link.joint().kind().quaternion().is_none())
        && mjcf::order(figure).into_iter().eq(0..figure.layout().nq())
}

fn is_newer(target: &Path, sources: &[&Path]) -> bool {
    let time = |path: &Path| fs::metadata(path).and_then(|file| file.modified()).ok();
    time(target).is_some_and(|target| sources.iter().all(|source| time(source) < Some(target)))
}

fn run<S: AsRef<OsStr>>(program: impl AsRef<OsStr>, args: impl IntoIterator<Item = S>) -> Result<(), String> {
    finish(Command::new(program).args(args)).map(drop)
}

fn said(program: &Path, args: &[&str]) -> Result<String, String> {
    finish(Command::new(program).args(args))
}

/// What a command says, once it has ended well.
fn finish(command: &mut Command) -> Result<String, String> {
    let name = command.get_program().to_string_lossy().into_owned();
    let done = command.stderr(Stdio::inherit()).output().map_err(|error| format!("{name}: {error}"))?;
    if !done.status.success() {
        return Err(format!("{name} failed ({})", done.status));
    }
    Ok(String::from_utf8_lossy(&done.stdout).into_owned())
}
