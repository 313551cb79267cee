//! The peers bench: installs other people's solvers, builds, and runs all side by side.

use std::path::{Path, PathBuf};
use std::{ffi::OsString, process::Command};

use crate::{apt, command, error::Error, needs::succeeds};

const BENCH: &str = "benches/peers";

/// Folder of the build, the Python environment, and the report of a quick run.
const WORK: &str = "target/peers";

#[derive(Clone, PartialEq, Eq, Debug, Default)]
pub(crate) struct PeerOptions {
    /// `true` to see only that everything runs.
    pub(crate) quick: bool,
    /// Folder of the report; by default the committed one, unless `quick`.
    pub(crate) out: Option<PathBuf>,
}

/// Installs what is missing, builds, and runs the bench; a missing peer is no error.
pub(crate) fn run(options: &PeerOptions) -> Result<(), Error> {
    apt::install_missing()?;
    let root = command::root();
    let work = root.join(WORK);
    std::fs::create_dir_all(&work).map_err(|cause| Error::file(&work, cause))?;
    let mut arguments: Vec<OsString> = vec!["--out".into(), out(root, options).into()];
    if options.quick {
        arguments.push("--quick".into());
    }
    let obtained = [
        ("--cvode", "CVODE", cvode(root, &work)),
        ("--python", "SciPy, heyoka, MuJoCo and Drake", python(root, &work)),
        ("--siconos", "Siconos", siconos()),
    ];
    for (flag, code, obtained) in obtained {
        match obtained {
            Ok(path) => arguments.extend([flag.into(), path.into()]),
            Err(why) => {
                println!("skipped: {code}: {why}");
                arguments.extend(["--skipped".into(), format!("{code}: {why}").into()]);
            }
        }
    }
    run_with(arguments)
}

/// Compares the evaluations of pode and of the Rust peers with those of the committed report.
pub(crate) fn compare_counts() -> Result<(), Error> {
    let results = command::root().join(BENCH).join("results/results.json");
    run_with(vec!["--counts".into(), results.into()])
}

fn run_with(arguments: Vec<OsString>) -> Result<(), Error> {
    let fixed = ["run", "--release", "--locked", "--manifest-path", "benches/peers/Cargo.toml"];
    let folder = command::root().join(WORK).join("cargo");
    let folder = ["--target-dir".into(), folder.into(), "--".into()];
    let build = fixed.map(OsString::from).into_iter().chain(folder);
    command::run(&mut command::cargo(build.chain(arguments)))
}

fn out(root: &Path, options: &PeerOptions) -> PathBuf {
    let here = || std::env::current_dir().unwrap_or_else(|_| root.to_path_buf());
    match &options.out {
        // As typed, since the bench runs elsewhere.
        Some(out) => here().join(out),
        None if options.quick => root.join(WORK).join("results"),
        None => root.join(BENCH).join("results"),
    }
}

fn cvode(root: &Path, work: &Path) -> Result<PathBuf, Error> {
    const LIBRARIES: [&str; 6] = [
        "-lsundials_cvode",
        "-lsundials_nvecserial",
        "-lsundials_sunlinsoldense",
        "-lsundials_sunmatrixdense",
        "-lsundials_sunnonlinsolfixedpoint",
        "-lm",
    ];
    if !Path::new("/usr/include/cvode/cvode.h").exists() {
        apt::install(&["libsundials-dev"])?;
    }
    let program = work.join("cvode");
    let mut compiler = Command::new("cc");
    compiler.arg("-O2").arg(root.join(BENCH).join("external/cvode.c"));
    command::run(compiler.arg("-o").arg(&program).args(LIBRARIES))?;
    Ok(program)
}

/// Returns the system's Python with Siconos, which PyPI does not have.
fn siconos() -> Result<PathBuf, Error> {
    const PYTHON: &str = "/usr/bin/python3";
    if !succeeds(PYTHON, &["-c", "import siconos.kernel"]) {
        apt::install(&["python3-siconos"])?;
    }
    Ok(PYTHON.into())
}

fn python(root: &Path, work: &Path) -> Result<PathBuf, Error> {
    python_with(work, &root.join(BENCH).join("external/requirements.txt"))
}

/// Creates a Python environment in `work` with the packages of the file `requirements`.
pub(crate) fn python_with(work: &Path, requirements: &Path) -> Result<PathBuf, Error> {
    let environment = work.join("venv");
    let python = environment.join("bin/python");
    if !python.exists() {
        if !succeeds("python3", &["-c", "import ensurepip, venv"]) {
            apt::install(&["python3-venv"])?;
        }
        command::run(Command::new("python3").args(["-m", "venv"]).arg(&environment))?;
    }
    let mut pip = Command::new(&python);
    pip.args(["-m", "pip", "install", "--quiet", "--disable-pip-version-check", "--requirement"]);
    command::run(pip.arg(requirements))?;
    Ok(python)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_quick_run_leaves_the_committed_report_alone() {
        let root = Path::new("/w");
        let quick = PeerOptions { quick: true, out: None };
        assert_eq!(out(root, &quick), Path::new("/w/target/peers/results"));
        assert_eq!(out(root, &PeerOptions::default()), Path::new("/w/benches/peers/results"));
        let elsewhere = PeerOptions { quick: true, out: Some("/tmp/x".into()) };
        assert_eq!(out(root, &elsewhere), Path::new("/tmp/x"));
    }
}
