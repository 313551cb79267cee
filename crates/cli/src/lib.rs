//! The commands of `letoff`; [`Command`] lists them.
//!
//! Exit codes: 0 done, 1 something failed while running (a voice or a model, too), 2 wrong usage or
//! file, 3 no host runs (of `status`), 101 a panic, which is a bug.

pub mod about;
pub mod arguments;
mod ask;
mod attend;
mod board;
mod calibrate;
mod check;
mod child_program;
mod dash;
mod devices;
mod endpoints;
mod instruments;
mod lab;
mod live;
mod log;
pub mod manual;
mod midi_guardian;
mod model;
mod piece;
mod plan;
mod press;
pub mod progress;
mod record;
mod recording;
mod recover;
mod reload;
mod replay;
mod run;
mod service;
mod set;
mod signals;
pub mod simulate;
mod stable;
mod status;
mod stop;
mod streaming;
mod target;
mod tokens;

use std::io::{self, Write};
use std::process::ExitCode;
use std::thread;

use clap::{Parser, Subcommand};

use simulate::{CallerArgs, SimulateArgs};
use telemetry::log::Level;

use about::{print_json, print_report};

/// The host of force-feedback keyboards.
#[derive(Debug, Parser)]
#[command(name = "letoff", version = about::version(), about, arg_required_else_help = true)]
pub struct Letoff {
    #[command(subcommand)]
    pub command: Command,
}

/// The subcommand that was typed.
#[derive(Debug, Subcommand)]
pub enum Command {
    /// Runs the host; without a scene, 88 simulated keys and a virtual pianist.
    Run(Box<run::RunArgs>),
    /// Opens the window: keys, scopes, sliders, recordings.
    Dash(dash::DashArgs),
    /// Runs the host, and records everything that it does.
    Record(Box<record::RecordArgs>),
    /// Runs a recording again, and says the first bit that differs.
    Replay(replay::ReplayArgs),
    /// Saves what can be read of a recording that breaks off.
    Recover(recover::RecoverArgs),
    /// Simulates one key offline and writes its trajectory and events.
    Simulate(Box<SimulateArgs>),
    /// Simulated boards on pseudo-terminals or CAN, for developing without hardware.
    Board(board::BoardArgs),
    /// Checks a scene or an instrument: all mistakes at once, with line and column.
    Check(check::CheckArgs),
    /// Computes whether the links of a scene can carry what it asks of them.
    Plan(plan::PlanArgs),
    /// Measures how the keys of boards read and push, and writes it into files.
    Calibrate(calibrate::CalibrateArgs),
    /// Lists serial ports, CAN interfaces and MIDI ports, and why one is missing.
    Devices(devices::DevicesArgs),
    /// Lists the instruments, models and their parameters.
    Instruments(instruments::InstrumentsArgs),
    /// Prints what follows from the description of a model, or writes one to start from.
    Model(model::ModelArgs),
    /// Changes settings of the running host, for all keys: render.passivity=control.
    Set(set::SetArgs),
    /// Presses a simulated key of the running host, as long as this command runs.
    Press(press::PressArgs),
    /// Prints what the running host does, and how it goes.
    Status(status::StatusArgs),
    /// Takes all forces away at once, and ends the running host.
    Stop,
    /// Offline studies with reports.
    #[command(disable_help_flag = true)]
    Lab(lab::StudyArgs),
    /// Writes man pages of all commands, and completions for bash, zsh and fish.
    #[command(hide = true)]
    Manual(manual::ManualArgs),
    /// Holds the MIDI port and the notes of a host, which starts it.
    #[command(hide = true)]
    MidiGuardian(midi_guardian::MidiGuardianArgs),
}

/// Failure of a command, with its exit code.
#[derive(Debug)]
pub enum Failure {
    /// Failure during a run: exit code 1.
    Running(String),
    /// Wrong usage or invalid file: exit code 2.
    Usage(String),
    /// No host to ask: exit code 3.
    NoHost(String),
    /// Panic of a thread, which is a bug: exit code 101, as of every Rust program.
    Panicked(String),
    /// The reader closed the output, as `head` does: no failure.
    Unread,
}

impl Failure {
    fn system(error: &io::Error) -> Self {
        Self::Running(format!(
            "the system refused a thread, signals or descriptors: {error}; see `ulimit -a`"
        ))
    }

    fn tell(self) -> ExitCode {
        let (code, text) = match self {
            Self::Unread => return ExitCode::SUCCESS,
            Self::Running(text) => (1, text),
            Self::Usage(text) => (2, text),
            Self::NoHost(text) => (3, text),
            Self::Panicked(text) => (101, text),
        };
        log::tell_as(Level::Error, &text);
        ExitCode::from(code)
    }
}

/// Converts errors of the output, for `?`; other system errors are named where they occur.
impl From<io::Error> for Failure {
    fn from(error: io::Error) -> Self {
        if error.kind() == io::ErrorKind::BrokenPipe {
            return Self::Unread;
        }
        Self::Running(format!("the output cannot be written: {error}"))
    }
}

/// Returns the failure of a system call that any program would see.
#[expect(clippy::needless_pass_by_value, reason = "fits map_err")]
fn system(error: io::Error) -> Failure {
    Failure::system(&error)
}

pub fn run(letoff: &Letoff) -> ExitCode {
    finish(|out| {
        let done = dispatch(&letoff.command, out);
        if !matches!(letoff.command, Command::Run(_)) {
            report_interpretation();
        }
        done
    })
}

/// Runs a program on stdout, prints its failure, and returns the exit code.
pub fn finish(program: impl FnOnce(&mut dyn Write) -> Result<(), Failure>) -> ExitCode {
    about::start();
    let mut out = io::stdout().lock();
    let done = program(&mut out).and_then(|()| Ok(out.flush()?));
    done.map_or_else(Failure::tell, |()| ExitCode::SUCCESS)
}

/// Runs `program` on a thread called `name`, with a stack that does not depend on the shell.
pub fn main_thread(name: &str, program: impl FnOnce() -> ExitCode + Send + 'static) -> ExitCode {
    const STACK: usize = 8 << 20;
    match thread::Builder::new().name(name.to_owned()).stack_size(STACK).spawn(program) {
        // A panic is reported where it happens.
        Ok(running) => running.join().unwrap_or(ExitCode::from(101)),
        Err(error) => Failure::system(&error).tell(),
    }
}

fn report_interpretation() {
    if let Some(reason) = mechanism::interpreted() {
        let text =
            format!("models are interpreted, about ten times slower than compiled: {reason}");
        log::tell_as(Level::Warning, &text);
    }
}

fn tell(text: &str) {
    log::tell_as(Level::Info, text);
}

fn dispatch(command: &Command, out: &mut dyn Write) -> Result<(), Failure> {
    match command {
        Command::Run(args) => run::run(args, out),
        Command::Dash(args) => dash::run(args, out),
        Command::Record(args) => record::run(args, out),
        Command::Replay(args) => replay::run(args, out),
        Command::Recover(args) => recover::run(args, out),
        Command::Simulate(args) => simulate(args, out),
        Command::Board(args) => board::run(args, out),
        Command::Check(args) => check::run(args, out),
        Command::Plan(args) => plan::run(args, out),
        Command::Calibrate(args) => calibrate::run(args, out),
        Command::Devices(args) => devices::run(args, out),
        Command::Instruments(args) => instruments::run(args, out),
        Command::Model(args) => model::run(args, out),
        Command::Set(args) => set::run(args, out),
        Command::Press(args) => press::run(args, out),
        Command::Status(args) => status::run(args, out),
        Command::Stop => stop::run(out),
        Command::Lab(args) => lab::run(args),
        Command::Manual(args) => manual::run(args),
        Command::MidiGuardian(args) => midi_guardian::run(args),
    }
}

fn simulate(args: &SimulateArgs, out: &mut dyn Write) -> Result<(), Failure> {
    use simulate::SimulateError;
    let header = about::ReportHeader::of_command().fields();
    let caller = CallerArgs { header, ..args.caller.clone() };
    let args = &SimulateArgs { caller, ..args.clone() };
    simulate::run(args, out, &mut tell).map_err(|error| {
        let text = error.to_string();
        if let SimulateError::Summary(cause) = error {
            cause.into()
        } else if matches!(error, SimulateError::Usage(_)) {
            Failure::Usage(text)
        } else {
            Failure::Running(text)
        }
    })
}
