//! `letoff status`: prints the state of the running host.

use std::io::Write;

use clap::Args;
use telemetry::{BoardState, HostState, HostStatus, KeyIndex, RunProgress};
use time::OffsetDateTime;

use super::ask::ask;
use super::{Failure, about, print_report};
use host::control::{ControlError, Reply, Request, end_command, send_to_host};

/// What `letoff status` takes.
#[derive(Clone, Debug, Args)]
#[command(after_help = "Examples:
  letoff status              the host of this user, or else the service's
  letoff status --json
  letoff status --key C4     let-off, weights and repetition of a key as it plays now

Exit codes: 0 a host runs; 1 it hangs, or does not answer to this user, or the key has a fault; 3
none runs.")]
pub struct StatusArgs {
    /// Prints it as JSON.
    #[arg(long)]
    pub json: bool,
    /// Measures this key instead, as C4 or its MIDI number, and prints its figures and faults.
    #[arg(long, conflicts_with = "json", value_parser = super::press::key)]
    pub key: Option<KeyIndex>,
}

pub(super) fn run(args: &StatusArgs, out: &mut dyn Write) -> Result<(), Failure> {
    if let Some(key) = args.key {
        return ask(&Request::Figures { key: key.number() }, Failure::Running, out);
    }
    let answer = send_to_host(&Request::Status {}).map_err(|error| {
        let is_nobody = matches!(error, ControlError::NoHost { .. });
        if is_nobody {
            Failure::NoHost(error.to_string())
        } else {
            Failure::Running(error.to_string())
        }
    })?;
    let Reply::Status { status } = answer.map_err(Failure::Running)? else {
        return Err(Failure::Running("what answered is no host of this version".to_owned()));
    };
    if args.json {
        print_report(&status, out)?;
    } else {
        write!(out, "{}", text(&status))?;
    }
    if status.state == HostState::Stalled {
        return Err(Failure::Running(format!(
            "the host (process {0}) answers, but its ticks do not go on: boards that hear nothing \
             from it take their forces away by themselves (their watchdogs, within some \
             milliseconds); end it with `{1}` if `letoff stop` does not",
            status.process,
            i32::try_from(status.process).map_or_else(|_| String::new(), end_command)
        )));
    }
    Ok(())
}

fn text(status: &HostStatus) -> String {
    let HostStatus { process, run, midi, clients, .. } = status;
    let RunProgress { deadlines, voices, asleep, strikes, faults, muted, .. } = run;
    let since = i64::try_from(status.since).ok();
    let since = since.and_then(|it| OffsetDateTime::from_unix_timestamp(it).ok());
    let since = since.map_or_else(String::new, about::utc);
    let mut lines = vec![format!("{} (since {since}, process {process})", status.line())];
    if deadlines.ticks == 0 {
        return lines.concat() + "\n";
    }
    lines.push(format!("  voices      {voices}, {asleep} asleep; {strikes} strikes"));
    lines.push(format!(
        "  deadlines   of {} ticks at {} Hz late: {} own work, {} woken late, {} preempted; {} \
         never run",
        deadlines.ticks,
        run.tick_hz,
        deadlines.own_work,
        deadlines.woken_late,
        deadlines.preempted,
        deadlines.skipped
    ));
    lines.extend(run.pass.map(|pass| format!("  play list   pass {pass}")));
    if let Some([p50, p99, p999, max]) = deadlines.lateness_us {
        let quantiles = format!("p50 {p50:.1} p99 {p99:.1} p99.9 {p999:.1} max {max:.1} us");
        lines.push(format!("  lateness    {quantiles}"));
    }
    if !run.left_out.is_empty() {
        lines.push(format!("  overload    left out now: {}", run.left_out.join(", ")));
    }
    if let waited @ 1.. = run.waited {
        lines.push(format!("  waited      {waited} turns of voices for which there was no time"));
    }
    if let starved @ 1.. = run.starved {
        lines.push(format!(
            "  ERROR       voices waited in {starved} ticks that had time: report it with a recording"
        ));
    }
    lines.extend(status.boards.iter().map(board));
    lines.push(format!("  midi        {midi}"));
    lines.push(format!("  clients     {clients} of the stream"));
    lines.push(format!("  recording   {}", status.recording.as_deref().unwrap_or("none")));
    let muted = if muted.is_empty() { "none".to_owned() } else { muted.join(", ") };
    lines.push(format!("  faults      {faults} turns of voices; muted keys: {muted}"));
    lines.extend(status.last_faults.iter().map(|fault| format!("              {fault}")));
    lines.join("\n") + "\n"
}

fn board(it: &BoardState) -> String {
    let BoardState { link, number, state, gaps, .. } = it;
    let last = it.first_key + it.keys.saturating_sub(1);
    let (first, last) = (telemetry::key_name(it.first_key), telemetry::key_name(last));
    let trip = it.round_trip_us.map_or_else(String::new, |it| format!(", round trip {it:.0} us"));
    format!("  board       {number} on {link}, {first} to {last}: {state}; {gaps} gaps{trip}")
}
