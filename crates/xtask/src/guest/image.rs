//! The guest's file system: our program, a few others, and the kernel's modules.

use std::path::{Path, PathBuf};
use std::{collections::BTreeSet, process::Command};

use super::{GuestCheck, GuestSystem, kernel::Kernel};
use crate::{command, error::Error, files, needs, tools};

const FOLDERS: [&str; 9] =
    ["bin", "dev", "modules", "new", "proc", "sys", "this", "tmp", "written"];

/// Builds the file system below `folder`, and returns the file for QEMU.
pub(super) fn make(
    folder: &Path,
    guest: &GuestCheck,
    kernel: &Kernel,
    letoff: &Path,
) -> Result<PathBuf, Error> {
    let root = folder.join("root");
    files::empty(&root)?;
    for name in FOLDERS {
        files::make(&root.join(name))?;
    }
    let mut programs = vec![tools::path("busybox")?];
    if letoff.extension().is_some_and(|it| it == "deb") {
        files::copy(letoff, &root.join("letoff.deb"))?;
    } else {
        programs.push(letoff.to_owned());
    }
    // systemd uses this machine's files.
    if guest.system == GuestSystem::Busybox {
        for (name, _package) in guest.programs {
            programs.push(tools::path(name)?);
        }
    }
    programs.extend_from_slice(&guest.more);
    install(&programs, &root)?;
    add_modules(guest.modules, kernel, &root.join("modules"))?;
    for path in guest.copies.iter().map(Path::new) {
        copy(path, &root)?;
    }
    for (path, content) in &guest.files {
        files::write(&root.join(path), content)?;
    }
    files::write(&root.join("judge.sh"), include_str!("judge.sh"))?;
    files::write(&root.join("init"), guest.system.init())?;
    let initrd = folder.join("initrd");
    let pack = "chmod 755 init && find . | cpio --quiet -o -H newc >../initrd";
    command::run(Command::new("sh").args(["-c", pack]).current_dir(&root))?;
    Ok(initrd)
}

fn install(programs: &[PathBuf], root: &Path) -> Result<(), Error> {
    let mut needed = BTreeSet::new();
    for program in programs {
        let copy = root.join("bin").join(program.file_name().unwrap_or_default());
        files::copy(program, &copy)?;
        // The guest's memory is small; without strip it just suffices.
        needs::succeeds("strip", &["--strip-debug", &copy.to_string_lossy()]);
        // ldd fails on a static program, which needs no library.
        let output = Command::new("ldd").arg(program).output();
        let output = output.map_err(|cause| Error::file("ldd", cause))?;
        needed.extend(libraries(&String::from_utf8_lossy(&output.stdout)));
    }
    for library in needed {
        copy(&library, root)?;
    }
    Ok(())
}

fn copy(path: &Path, root: &Path) -> Result<(), Error> {
    let place = root.join(path.strip_prefix("/").unwrap_or(path));
    files::make(place.parent().unwrap_or(root))?;
    files::copy(path, &place)
}

fn libraries(ldd: &str) -> Vec<PathBuf> {
    ldd.split_whitespace().filter(|word| word.starts_with('/')).map(PathBuf::from).collect()
}

fn add_modules(modules: &[&str], kernel: &Kernel, to: &Path) -> Result<(), Error> {
    let dependencies = files::read(&kernel.modules.join("modules.dep"))?;
    let mut order = String::new();
    for Load { path, parameters } in load_order(modules, &dependencies)? {
        let name = format!("{}.ko", module(path));
        unpack(&kernel.modules.join(path), &to.join(&name))?;
        order.push_str(format!("{name} {parameters}").trim_end());
        order.push('\n');
    }
    files::write(&to.join("order"), order)
}

/// Copies a module; newer distributions compress them.
fn unpack(from: &Path, to: &Path) -> Result<(), Error> {
    let program = match from.extension().and_then(|extension| extension.to_str()) {
        Some("xz") => "xz",
        Some("zst") => "zstd",
        _ => return files::copy(from, to),
    };
    let mut command = Command::new(program);
    command.arg("-dc").arg(from);
    let words = command::words(&command);
    let output = command.output().map_err(|cause| Error::file(program, cause))?;
    if output.status.success() {
        files::write(to, output.stdout)
    } else {
        Err(Error::Failed { command: words })
    }
}

#[derive(PartialEq, Eq, Debug)]
struct Load<'a> {
    path: &'a str,
    parameters: &'a str,
}

fn load_order<'a>(modules: &[&'a str], modules_dep: &'a str) -> Result<Vec<Load<'a>>, Error> {
    let mut order: Vec<Load<'a>> = Vec::new();
    for wanted in modules {
        let (wanted, parameters) = wanted.split_once(' ').unwrap_or((wanted, ""));
        let found = modules_dep
            .lines()
            .filter_map(|line| line.split_once(':'))
            .find(|(path, _)| module(path) == wanted);
        let (path, needed) = found.ok_or_else(|| {
            let what = format!("the module {wanted}");
            Error::unobtainable(what, "the kernel's packages have none")
        })?;
        // Dependencies are listed in reverse order.
        let needed = needed.split_whitespace().rev().map(|path| Load { path, parameters: "" });
        for load in needed.chain([Load { path, parameters }]) {
            if order.iter().all(|it| it.path != load.path) {
                order.push(load);
            }
        }
    }
    Ok(order)
}

fn module(path: &str) -> String {
    let file = path.rsplit('/').next().unwrap_or(path);
    file.split(".ko").next().unwrap_or(file).replace('_', "-")
}

#[cfg(test)]
mod tests {
    use super::*;

    const MODULES_DEP: &str = "\
kernel/sound/snd-seq.ko: kernel/sound/snd-timer.ko kernel/sound/snd.ko
kernel/sound/snd-seq-dummy.ko: kernel/sound/snd-seq.ko kernel/sound/snd-timer.ko kernel/sound/snd.ko
kernel/sound/snd.ko:
kernel/sound/snd_virmidi.ko.xz: kernel/sound/snd-seq.ko kernel/sound/snd-timer.ko kernel/sound/snd.ko
";

    #[test]
    fn a_module_is_loaded_once_and_after_those_it_needs() {
        let modules = ["snd-seq", "snd-virmidi index=1", "snd-seq-dummy"];
        let order = load_order(&modules, MODULES_DEP).unwrap();
        let names: Vec<_> = order.iter().map(|it| module(it.path)).collect();
        assert_eq!(names, ["snd", "snd-timer", "snd-seq", "snd-virmidi", "snd-seq-dummy"]);
        let parameters: Vec<_> = order.iter().map(|it| it.parameters).collect();
        assert_eq!(parameters, ["", "", "", "index=1", ""]);
    }

    #[test]
    fn a_kernel_without_a_module_is_refused_by_its_name() {
        let error =
            load_order(&["snd-virmidi"], "kernel/sound/snd-seq.ko:\n").unwrap_err().to_string();
        assert!(error.contains("snd-virmidi"), "{error}");
    }

    #[test]
    fn libraries_are_the_paths_that_ldd_prints() {
        let ldd = "\tlinux-vdso.so.1 (0x1)\n\tlibc.so.6 => /lib/x86_64-linux-gnu/libc.so.6 (0x2)\n\
                   \t/lib64/ld-linux-x86-64.so.2 (0x3)\n";
        let expected = ["/lib/x86_64-linux-gnu/libc.so.6", "/lib64/ld-linux-x86-64.so.2"];
        assert_eq!(libraries(ldd), expected.map(PathBuf::from));
        assert!(libraries("\tnot a dynamic executable\n").is_empty());
    }
}
