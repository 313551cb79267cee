use std::path::PathBuf;

use clap::{Args, Parser, ValueEnum};
use pode::stepper::{Rk4, Stepper as _};

const EXAMPLES: &str = "\
Examples:
  letoff simulate key-hammer-springs --until 3 --step 1e-3 \\
      --input 's=0.1*sin(2*pi*t)' --out traj.csv --events events.csv
  letoff simulate bouncing-ball --until 4 --step 1e-3 --plot ball.svg
  letoff simulate my-action.toml --until 1 --step 1e-3 --out traj.csv
  letoff simulate key-hammer-springs --until 1 --step 1e-4 --method heun --json \\
      --input stroke.csv --reconstruct hermite --set k1=62 k2=150 --initial theta_h=0.1

Exit codes: 0 done; 1 the model failed while running, or a file could not be written;
2 wrong usage or file.

Trajectory columns: t, mode, the states, the input by its name (as s; none without an input),
guard_<name> for each guard (empty where the
present mode does not have it), the outputs (output_<name> where a column has that name).
Event columns: t, guard, from, to, <state>_before ..., <state>_after ..., impulse,
error (how far t may be wrong), projection (how far a constraint moved the state), stands_for (1
where a guard fired; how many impacts were taken together, in closed form; inf where all that were
left were taken so, until rest).";

/// Plays one key offline and writes what it did.
///
/// Advances a model in ticks of --step from 0 to --until, locates its events, and writes
/// its trajectory and its events as CSV. Units are SI: m, kg, s, N, rad.
#[derive(Parser, Clone, PartialEq, Debug)]
#[command(name = "simulate", after_help = EXAMPLES)]
pub struct SimulateArgs {
    /// The model's name, which `letoff instruments` lists, or the path of its description.
    #[arg(value_name = "MODEL")]
    pub model: String,

    /// Parameter set; the model's first if not given.
    #[arg(long, value_name = "P")]
    pub preset: Option<String>,

    /// Key for which a graded preset is taken, 0 (A0) to 87 (C8).
    #[arg(long, value_name = "N", default_value_t = MIDDLE_C)]
    pub key: u8,

    /// The input s over time (s): a CSV file with the header `t,s`, or an expression of t.
    ///
    /// An expression is exact with its derivatives; it has + - * / ^, parentheses, pi, e,
    /// tau, sin, cos, tan, asin, acos, atan, sinh, cosh, tanh, asinh, acosh, atanh, exp,
    /// ln, log2, log10, sqrt, and with corners and jumps abs, sign, min(a, b), max(a, b),
    /// if(a > b, x, y). Without --input, s = 0.
    #[arg(long, value_name = "FILE.csv|s=EXPR")]
    pub input: Option<String>,

    /// How s goes on between the rows of the CSV file [default: spline].
    #[arg(long, value_enum, value_name = "HOW")]
    pub reconstruct: Option<Reconstruct>,

    /// Parameters that differ from the preset, in their own unit.
    #[arg(long, value_name = "NAME=VALUE", num_args = 1..)]
    pub set: Vec<String>,

    /// Mode at the start; the mode at rest if not given.
    #[arg(long, value_name = "M")]
    pub mode: Option<String>,

    /// States at the start that differ from rest under the input at t = 0, in SI units;
    /// what the mode slaves to the input stays with the input.
    #[arg(long, value_name = "NAME=VALUE", num_args = 1..)]
    pub initial: Vec<String>,

    /// End of the simulation (s).
    #[arg(long, value_name = "T", allow_negative_numbers = true)]
    pub until: f64,

    /// Length of a tick and longest step (s); the last tick is shorter where T asks for it.
    #[arg(long, value_name = "H", allow_negative_numbers = true)]
    pub step: f64,

    /// Method. Explicit, by order: explicit-euler, semi-implicit-euler, heun, velocity-verlet,
    /// adams-bashforth2, adams-bashforth3, bogacki-shampine, rk4, tsitouras5. For stiff modes:
    /// linear-implicit-midpoint (makes no energy), rodas3. For actions with felts: newmark (rk4 in
    /// modes without a mass matrix). For linear modes: exact (rk4 in the others). For long steps:
    /// dop853. The cheapest that will do, mode by mode: by-need.
    #[arg(long, value_name = "M", default_value = Rk4::NAME)]
    pub method: String,

    /// Error that may be made: with by-need relative and per radian of a mode's fastest motion
    /// [default: 1e-4]; with bogacki-shampine, tsitouras5 and dop853 of each step, absolute and
    /// relative: their steps are then as long as it allows, up to a tick.
    #[arg(long, value_name = "E", allow_negative_numbers = true)]
    pub tolerance: Option<f64>,

    /// Width to which an event is located, as a fraction of a tick, 1e-16 to 0.5
    /// [default: 2^-40].
    #[arg(long, value_name = "THETA", allow_negative_numbers = true)]
    pub event_tolerance: Option<f64>,

    #[command(flatten)]
    pub output: OutputArgs,

    /// What no option says.
    #[arg(skip)]
    pub caller: CallerArgs,
}

/// Wishes of a program that simulates.
#[derive(Clone, PartialEq, Eq, Debug, Default)]
pub struct CallerArgs {
    /// Number of the first tick.
    pub first_tick: u64,
    /// The fields with which the JSON begins: which program made it, and when.
    pub header: serde_json::Map<String, serde_json::Value>,
    /// `true` if the events are kept in memory too.
    pub lists_events: bool,
}

/// What `letoff simulate` writes.
#[derive(Args, Clone, PartialEq, Eq, Debug)]
pub struct OutputArgs {
    /// File for the trajectory: one row at t = 0 and one at the end of every tick.
    #[arg(long, value_name = "FILE")]
    pub out: Option<PathBuf>,

    /// File for the events: one row each, t to 17 digits, state before and after.
    #[arg(long, value_name = "FILE")]
    pub events: Option<PathBuf>,

    /// SVG file for a plot over time: forces, guards, coordinates and s; modes as shades,
    /// events as lines.
    #[arg(long, value_name = "FILE.svg")]
    pub plot: Option<PathBuf>,

    /// Print counts, final state and energy audit as one JSON object.
    #[arg(long)]
    pub json: bool,
}

const MIDDLE_C: u8 = 39;

/// How a sampled input goes on between its samples; outside them the end values hold.
#[derive(ValueEnum, Clone, Copy, PartialEq, Eq, Debug, Default)]
pub enum Reconstruct {
    /// The sample before, at rest; order 1, jumps.
    Hold,
    /// The line between the neighbours; order 2, its rate jumps.
    Linear,
    /// The parabola through both neighbours and the sample before them (after them in the
    /// first interval); order 3, its rate jumps.
    Quadratic,
    /// The cubic with central-difference slopes; order 3, its acceleration jumps.
    Hermite,
    /// The not-a-knot cubic spline; order 4, its jerk jumps.
    #[default]
    Spline,
}
