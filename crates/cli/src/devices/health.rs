//! `letoff devices --boards --health`: health of boards and keys, and keys with motors off.

use std::io::Write;

use boards::keybed::{FoundBoard, Identified, Keybed};
use boards::refusal::Refusal;
use firmware_protocol::Nothing;
use firmware_protocol::acyclic::Operation;
use firmware_protocol::acyclic::health::{
    BoardHealth, KeyHealth, MuteKey, NOT_MEASURED, ReadKeyHealth, key_fault,
};
use firmware_protocol::key::KeyIndex;
use serde::Serialize;

use crate::Failure;

#[derive(Debug, Serialize)]
pub(super) struct HealthRow {
    starts: u32,
    keys: Vec<KeyHealthRow>,
}

#[derive(Debug, Serialize)]
struct KeyHealthRow {
    key: String,
    is_homed: bool,
    is_muted: bool,
    fault: &'static str,
    /// Temperature (°C) and current (A) of its motor, if measured.
    temperature: Option<f64>,
    current: Option<f64>,
}

pub(super) fn read(
    found: &FoundBoard,
    keybed: &mut Keybed<Identified>,
) -> Result<HealthRow, Refusal> {
    let mut asker = keybed.asker(found.line, found.board);
    let board: BoardHealth = keybed.ask(&mut asker, Operation::BoardHealth, &Nothing)?;
    let mut keys = Vec::new();
    for slot in 0..found.hello.n_keys {
        let health: KeyHealth =
            keybed.ask(&mut asker, Operation::KeyHealth, &ReadKeyHealth { slot })?;
        let key = KeyIndex::new(found.hello.first_key.saturating_add(slot));
        let is_set = |bits: u16| bits >> slot.min(15) & 1 == 1;
        let is_failed = is_set(board.faults);
        keys.push(KeyHealthRow {
            key: key.map_or_else(|| format!("slot {slot}"), |key| key.to_string()),
            is_homed: is_set(board.homed),
            is_muted: is_set(board.muted),
            fault: match health.fault {
                key_fault::NONE if is_failed => "failed",
                key_fault::NONE => "none",
                key_fault::SENSOR => "sensor",
                key_fault::MOTOR => "motor",
                key_fault::TOO_HOT => "too hot",
                _ => "another fault",
            },
            temperature: measured(health.temperature, 0.1),
            current: measured(health.current, 1e-3),
        });
    }
    Ok(HealthRow { starts: board.boots, keys })
}

fn measured(value: i16, unit: f64) -> Option<f64> {
    (value != NOT_MEASURED).then(|| f64::from(value) * unit)
}

/// Switches the motor of `key`, one of this board's, off (1) or on (0).
pub(super) fn mute(
    found: &FoundBoard,
    keybed: &mut Keybed<Identified>,
    key: KeyIndex,
    muted: u8,
) -> Result<(), Refusal> {
    let slot = key.number().wrapping_sub(found.hello.first_key);
    let mut asker = keybed.asker(found.line, found.board);
    let _done: Nothing = keybed.ask(&mut asker, Operation::MuteKey, &MuteKey { slot, muted })?;
    Ok(())
}

pub(super) fn print(health: &HealthRow, out: &mut dyn Write) -> Result<(), Failure> {
    writeln!(out, "    started {} times", health.starts)?;
    for it in &health.keys {
        let homed = if it.is_homed { "homed" } else { "NOT HOMED" };
        let muted = if it.is_muted { ", MUTED" } else { "" };
        let hot = it.temperature.map_or_else(String::new, |it| format!(", {it:.1} °C"));
        let current = it.current.map_or_else(String::new, |it| format!(", {it:.2} A"));
        writeln!(out, "    {:4} {homed}{muted}, fault: {}{hot}{current}", it.key, it.fault)?;
    }
    Ok(())
}
