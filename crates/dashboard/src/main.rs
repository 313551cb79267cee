//! `letoff-dashboard`: the window for a host or a recording.

#![forbid(unsafe_code)]

use std::path::{Path, PathBuf};
use std::{io, process::ExitCode, sync::Arc};

use clap::{CommandFactory as _, Parser};
use clap_complete::aot::{Shell, generate_to};
use dashboard::open::{Sentence, WindowTarget, open};
use dashboard::{App, RepaintWaker, SavedWindow, wall_clock};
use eframe::egui;

/// Default address of hosts.
const USUAL: &str = "127.0.0.1:8765";

/// Shows what a host of force-feedback keys does, and changes it.
#[derive(Parser, Debug)]
#[command(name = "letoff-dashboard", version)]
struct DashboardArguments {
    /// A host's address, or a recording (.mcap).
    #[arg(value_name = "ADDRESS | FILE.mcap", default_value = USUAL)]
    target: String,
    /// Control socket of a host on this machine, which is asked for its address and secret, also
    /// after the host was started again.
    #[arg(long, value_name = "PATH", conflicts_with_all = ["token", "fingerprint", "demo"])]
    socket: Option<PathBuf>,
    /// What the host wants to hear before something may be changed; or LETOFF_TOKEN has it.
    #[arg(long)]
    token: Option<String>,
    /// What the host's certificate must be, as the host prints it.
    #[arg(long)]
    fingerprint: Option<String>,
    /// Plays a recorded take again and again, without a host.
    #[arg(long)]
    demo: bool,
    /// Writes a man page, and completions for bash, zsh and fish, into this folder.
    #[arg(long, value_name = "DIR", hide = true)]
    manual: Option<PathBuf>,
}

fn main() -> ExitCode {
    let arguments = DashboardArguments::parse();
    match run(arguments) {
        Ok(()) => ExitCode::SUCCESS,
        Err(sentence) => {
            #[expect(clippy::print_stderr, reason = "a command tells why it ends")]
            {
                eprintln!("letoff-dashboard: {sentence}");
            }
            ExitCode::FAILURE
        }
    }
}

fn run(arguments: DashboardArguments) -> Result<(), Sentence> {
    if let Some(folder) = arguments.manual {
        let told = |error| Sentence(format!("{} cannot be written to: {error}", folder.display()));
        return write_manual(&folder).map_err(told);
    }
    let target = if arguments.demo {
        WindowTarget::Demonstration
    } else if let Some(path) = arguments.socket {
        WindowTarget::Socket(path)
    } else {
        let token = arguments.token.or_else(|| std::env::var("LETOFF_TOKEN").ok());
        WindowTarget::of(&arguments.target, token, arguments.fingerprint)
    };
    // Before there is a window: an invalid address is reported without one.
    let window: Arc<std::sync::OnceLock<egui::Context>> = Arc::default();
    let waiting = Arc::clone(&window);
    let wake: RepaintWaker = Arc::new(move |soon| {
        if let Some(ctx) = waiting.get() {
            ctx.request_repaint_after(soon);
        }
    });
    let source = open(&target, &wake)?;
    let options = eframe::NativeOptions {
        viewport: egui::ViewportBuilder::default()
            .with_title("Letoff")
            .with_app_id("letoff-dashboard")
            .with_inner_size([1280.0, 800.0])
            .with_min_inner_size([640.0, 400.0]),
        ..eframe::NativeOptions::default()
    };
    let create = move |cc: &eframe::CreationContext<'_>| {
        let _first = window.set(cc.egui_ctx.clone());
        let memory = cc.storage.and_then(SavedWindow::load);
        let app = App::new(source, wall_clock(), memory, &cc.egui_ctx);
        let app: Box<dyn eframe::App> = Box::new(app);
        Ok(app)
    };
    eframe::run_native("letoff-dashboard", options, Box::new(create)).map_err(|it| sentence(&it))
}

fn write_manual(folder: &Path) -> io::Result<()> {
    std::fs::create_dir_all(folder)?;
    clap_mangen::generate_to(DashboardArguments::command(), folder)?;
    for shell in [Shell::Bash, Shell::Zsh, Shell::Fish] {
        generate_to(shell, &mut DashboardArguments::command(), "letoff-dashboard", folder)?;
    }
    Ok(())
}

fn sentence(error: &eframe::Error) -> Sentence {
    // The last part is the message; those before are positions in foreign sources.
    let cause = error.to_string();
    let cause = cause.rsplit(": ").next().unwrap_or_default().trim_end_matches('.');
    let advice = match error {
        eframe::Error::WinitEventLoop(_) | eframe::Error::Winit(_) => {
            "there is no display to open a window on; set DISPLAY or WAYLAND_DISPLAY, or use ssh -X"
        }
        eframe::Error::Glutin(_)
        | eframe::Error::NoGlutinConfigs(..)
        | eframe::Error::OpenGL(_) => {
            "the display has no OpenGL; install libgl1-mesa-dri for one in software"
        }
        eframe::Error::AppCreation(_) => "the window could not be made",
    };
    Sentence(format!("{advice} ({cause})"))
}
