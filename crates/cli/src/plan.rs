//! `letoff plan SCENE`: checks whether the links can carry the scene.

use std::io::Write;

use boards::plan::{BusPlan, BusVerdict, NoPlan, Proposal};
use clap::Args;
use firmware_protocol::frame::key_forces::ForcePacking;
use firmware_protocol::frame::key_samples::SamplePacking;
use serde::Serialize;

use super::stable::refuse_unstable;
use super::target::SceneTarget;
use super::{Failure, print_json};
use host::connected_boards::planning;
use scene::{BoardBus, Boards, FORCES, SAMPLES};

/// What `letoff plan` takes.
#[derive(Clone, Debug, Args)]
#[command(after_help = "Examples:
  letoff plan my-scene.toml
  letoff plan --link can:can0 --link can:can1

The default scene, like every scene with simulated keys, has no links: give it --link.
Boards that the scene does not list are the standard ones: 8 of 11 keys, spread evenly.")]
pub struct PlanArgs {
    /// What shall be planned.
    #[command(flatten)]
    pub target: SceneTarget,
    /// Prints the plan as JSON.
    #[arg(long)]
    pub json: bool,
}

#[derive(Debug, Serialize)]
struct PlanRow {
    link: String,
    /// Medium; `None` if unknown or without transmission time.
    medium: Option<String>,
    planned: Option<Planned>,
    sentences: Vec<String>,
}

#[derive(Debug, Serialize)]
struct Planned {
    boards: usize,
    keys: usize,
    samples: &'static str,
    forces: &'static str,
    hz: f64,
    /// Worst-case share of its time.
    load: f64,
    most_hz: f64,
    /// Worst-case time until the last force frame.
    force_response_us: Option<f64>,
    /// Worst-case time that the most urgent frame waits for a frame in transmission.
    blocking_us: f64,
    verdict: &'static str,
    proposal: Proposed,
}

#[derive(Debug, Serialize)]
struct Proposed {
    samples: &'static str,
    forces: &'static str,
    hz: f64,
    /// Number of such links for the wanted rate with these packings.
    links: Option<usize>,
}

/// Prints the plan of every link; fails if one is overloaded, or if keys are unstable at this rate.
pub(super) fn run(args: &PlanArgs, out: &mut dyn Write) -> Result<(), Failure> {
    let (scene, boards) = args.target.boards()?;
    let plans = planning::assumed(&boards, scene.tick_hz);
    let rows = rows(&boards, &plans);
    if args.json {
        print_json(&rows, out)?;
    } else {
        print(&rows, out)?;
    }
    let refused = planning::sentences(plans.iter().flatten(), BusVerdict::Refused);
    if !refused.is_empty() {
        return Err(Failure::Usage(refused.join("\nletoff: ")));
    }
    refuse_unstable(&scene)
}

fn rows(boards: &Boards, plans: &[Result<BusPlan, NoPlan>]) -> Vec<PlanRow> {
    boards.buses.iter().zip(plans).map(|(bus, plan)| row(bus, plan)).collect()
}

fn row(bus: &BoardBus, plan: &Result<BusPlan, NoPlan>) -> PlanRow {
    let medium = host::connected_boards::medium(bus).ok();
    PlanRow {
        link: bus.address.place.clone(),
        medium: medium.map(|it| it.to_string()),
        planned: plan.as_ref().ok().map(planned),
        sentences: match plan {
            Ok(plan) => vec![plan.sentence(), proposed(plan)],
            Err(why) => vec![format!("{}: {why}", bus.address)],
        },
    }
}

fn planned(plan: &BusPlan) -> Planned {
    Planned {
        boards: plan.boards.len(),
        keys: plan.boards.iter().map(|it| it.numbers().len()).sum(),
        samples: name(&SAMPLES, plan.samples),
        forces: name(&FORCES, plan.forces),
        hz: plan.sample_rate,
        load: plan.load(),
        most_hz: plan.max_rate(),
        force_response_us: plan.force_response(),
        blocking_us: plan.blocking(),
        verdict: match plan.verdict() {
            BusVerdict::Fits => "fits",
            BusVerdict::Tight => "tight",
            BusVerdict::Refused => "refused",
        },
        proposal: match plan.propose() {
            Proposal::AsWanted(it) => proposal(&it, Some(1)),
            Proposal::Slower { plan, buses } => proposal(&plan, buses),
        },
    }
}

fn proposal(plan: &BusPlan, links: Option<usize>) -> Proposed {
    Proposed {
        samples: name(&SAMPLES, plan.samples),
        forces: name(&FORCES, plan.forces),
        hz: plan.sample_rate,
        links,
    }
}

fn proposed(plan: &BusPlan) -> String {
    let packing = |plan: &BusPlan| {
        let (samples, forces) = (name(&SAMPLES, plan.samples), name(&FORCES, plan.forces));
        format!("samples = \"{samples}\", forces = \"{forces}\"")
    };
    match plan.propose() {
        Proposal::AsWanted(it) if it == *plan => {
            format!("{}: no richer packing fits", plan.name)
        }
        Proposal::AsWanted(it) => {
            format!("{}: the richest that fits is {}", plan.name, packing(&it))
        }
        Proposal::Slower { plan: it, buses } => {
            let with = format!("{}: with {}", plan.name, packing(&it));
            let hz = it.sample_rate;
            match buses {
                Some(n) => {
                    format!("{with} it carries {hz} Hz, and {n} such links all that is wanted")
                }
                None => format!("{with} it carries {hz} Hz, and one board is too much for more"),
            }
        }
    }
}

fn name<T: PartialEq + Copy>(names: &[(&'static str, T)], wanted: T) -> &'static str {
    names.iter().find(|(_, it)| *it == wanted).map_or("", |(name, _)| name)
}

const _: () = assert!(SAMPLES.len() == SamplePacking::ALL.len());
const _: () = assert!(FORCES.len() == ForcePacking::ALL.len());

fn print(rows: &[PlanRow], out: &mut dyn Write) -> Result<(), Failure> {
    writeln!(
        out,
        "{:16} {:24} {:>6} {:>5} {:>6} {:>8} {:>7} {:>9} {:>9}  verdict",
        "link", "medium", "boards", "keys", "Hz", "load", "most Hz", "force us", "blocks us"
    )?;
    for row in rows {
        let medium = row.medium.as_deref().unwrap_or("-");
        write!(out, "{:16} {medium:24}", row.link)?;
        match &row.planned {
            None => writeln!(out, " {:>6} {:>5}", "-", "-")?,
            Some(it) => writeln!(
                out,
                " {:6} {:5} {:6.0} {:6.1} % {:7.0} {:>9} {:9.0}  {}",
                it.boards,
                it.keys,
                it.hz,
                100.0 * it.load,
                it.most_hz,
                it.force_response_us.map_or_else(|| "never".to_owned(), |us| format!("{us:.0}")),
                it.blocking_us,
                it.verdict
            )?,
        }
    }
    writeln!(out)?;
    rows.iter().flat_map(|row| &row.sentences).try_for_each(|it| Ok(writeln!(out, "{it}")?))
}

#[cfg(test)]
mod tests {
    use super::*;
    use boards::links::address::Address;

    fn args(links: &[&str]) -> PlanArgs {
        let links = links.iter().map(|it| Address::parse(it).unwrap()).collect();
        PlanArgs {
            target: SceneTarget { scene: "default".into(), links, set: Vec::new() },
            json: false,
        }
    }

    fn planned(args: &PlanArgs) -> (String, Result<(), Failure>) {
        let mut out = Vec::new();
        let done = run(args, &mut out);
        (String::from_utf8(out).unwrap(), done)
    }

    #[test]
    fn one_bus_for_all_boards_at_1_khz_is_refused_with_the_numbers() {
        let (text, done) = planned(&args(&["can:can0"]));
        assert!(text.contains("8    88   1000  195.3 %") && text.contains("refused"), "{text}");
        assert!(text.contains("and 3 such links all that is wanted"), "{text}");
        let Err(Failure::Usage(why)) = done else { panic!("{done:?}") };
        assert!(why.contains("would take 195.3 % of its time, and 80 %"), "{why}");
    }

    #[test]
    fn four_buses_carry_it_and_what_is_not_known_is_said() {
        let links = ["can:can0", "can:can1", "can:can2", "can:can3"];
        let (text, done) = planned(&args(&links));
        assert!(done.is_ok() && text.contains("fits"), "{text}");
        let (text, done) = planned(&args(&["serial:/dev/pts/77"]));
        assert!(done.is_ok() && text.contains("nothing is planned"), "{text}");
    }

    #[test]
    fn a_program_reads_the_same_numbers() {
        let (text, _) = planned(&PlanArgs { json: true, ..args(&["can:can0"]) });
        let rows: serde_json::Value = serde_json::from_str(&text).unwrap();
        let it = &rows[0]["planned"];
        assert_eq!((it["keys"].as_u64(), it["verdict"].as_str()), (Some(88), Some("refused")));
        assert!((it["load"].as_f64().unwrap() - 1.95).abs() < 0.01, "{text}");
    }
}
