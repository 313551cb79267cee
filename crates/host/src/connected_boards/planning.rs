//! Load of a scene's links against their capacity.

use boards::keybed::{Calibrated, Keybed};
use boards::plan::{BusPlan, BusVerdict, Extras, NoPlan, standard};
use firmware_protocol::key::BOARDS;
use keyboard::KeyRange;

use scene::{BoardBus, Boards};

/// Plans the links of `boards` at `tick_hz`, except those without a list or with unknown times.
pub fn listed(boards: &Boards, tick_hz: u32) -> Vec<BusPlan> {
    let buses = boards.buses.iter();
    buses.filter_map(|bus| plan(boards, bus, listed_on(bus), tick_hz).ok()).collect()
}

/// Like [`listed`], with an entry for each link; those without a list share the other boards.
pub fn assumed(boards: &Boards, tick_hz: u32) -> Vec<Result<BusPlan, NoPlan>> {
    let keys = shares(boards).into_iter().zip(&boards.buses);
    keys.map(|(keys, bus)| plan(boards, bus, keys, tick_hz)).collect()
}

/// Plans all links of a keybed with known boards; `None` where times are unknown.
pub fn found(boards: &Boards, keybed: &Keybed<Calibrated>, tick_hz: u32) -> Vec<Option<BusPlan>> {
    let lines = keybed.line_names().zip(keybed.media()).enumerate();
    let plans = lines.map(|(line, (name, medium))| {
        let plan = of(boards, name.to_owned(), medium?, keybed.boards_on(line), tick_hz);
        Some(plan)
    });
    plans.collect()
}

pub fn sentences<'a, P: IntoIterator<Item = &'a BusPlan>>(
    plans: P,
    verdict: BusVerdict,
) -> Vec<String> {
    let plans = plans.into_iter().filter(|plan| plan.verdict() == verdict);
    plans.map(BusPlan::sentence).collect()
}

fn plan(
    boards: &Boards,
    bus: &BoardBus,
    keys: Vec<KeyRange>,
    tick_hz: u32,
) -> Result<BusPlan, NoPlan> {
    let medium = super::medium(bus)?;
    if keys.is_empty() {
        return Err(NoPlan::NoBoards);
    }
    Ok(of(boards, bus.address.place.clone(), medium, keys, tick_hz))
}

fn of(
    boards: &Boards,
    name: String,
    medium: boards::plan::Medium,
    keys: Vec<KeyRange>,
    tick_hz: u32,
) -> BusPlan {
    BusPlan {
        name,
        medium,
        boards: keys,
        samples: boards.samples,
        forces: boards.forces,
        sample_rate: tick_hz.into(),
        force_rate: tick_hz.into(),
        extras: Extras::default(),
    }
}

fn listed_on(bus: &BoardBus) -> Vec<KeyRange> {
    bus.boards.iter().map(|(_, keys)| *keys).collect()
}

/// Returns the keys of each board on each link; boards without a list follow one another.
fn shares(boards: &Boards) -> Vec<Vec<KeyRange>> {
    let listed: usize = boards.buses.iter().map(|bus| bus.boards.len()).sum();
    let mut rest = BOARDS.saturating_sub(listed);
    let mut open = boards.buses.iter().filter(|bus| bus.boards.is_empty()).count();
    let mut share = |bus: &BoardBus| {
        if !bus.boards.is_empty() {
            return listed_on(bus);
        }
        // The first links have one more if the boards cannot be shared evenly.
        let n = rest.div_ceil(open.max(1));
        let first = BOARDS - rest;
        (rest, open) = (rest - n, open.saturating_sub(1));
        standard(first..first + n)
    };
    boards.buses.iter().map(&mut share).collect()
}

#[cfg(test)]
mod tests {
    use super::*;
    use boards::links::address::Address;

    fn boards(links: &[&str]) -> Boards {
        let bus = |link: &&str| BoardBus::new(Address::parse(link).unwrap());
        Boards { buses: links.iter().map(bus).collect(), ..Boards::default() }
    }

    #[test]
    fn boards_of_which_nothing_is_said_are_spread_evenly() {
        let n = |links: &[&str]| shares(&boards(links)).iter().map(Vec::len).collect::<Vec<_>>();
        assert_eq!(n(&["can:can0"]), [8]);
        assert_eq!(n(&["can:can0", "can:can1", "can:can2"]), [3, 3, 2]);
        let mut some = boards(&["can:can0", "can:can1"]);
        some.buses[0].boards = vec![(0, KeyRange::parse("A0..G#1").unwrap()); 3];
        assert_eq!(shares(&some), [vec![KeyRange::parse("A0..G#1").unwrap(); 3], standard(3..8)]);
    }

    #[test]
    fn a_link_without_a_plan_says_why() {
        let mut some = boards(&["can:can0", "can:vcan0", "serial:/dev/pts/9", "can:can1"]);
        some.buses[0].boards = vec![(0, KeyRange::parse("A0..G1").unwrap()); 8];
        let why: Vec<_> = assumed(&some, 1_000).into_iter().map(Result::err).collect();
        let (virtual_, rates, boards) = (NoPlan::Virtual, NoPlan::NoRates, NoPlan::NoBoards);
        assert_eq!(why, [None, Some(virtual_), Some(rates), Some(boards)]);
    }

    #[test]
    fn only_links_whose_boards_are_listed_are_planned_before_anybody_is_asked() {
        let mut some = boards(&["can:can0", "can:vcan0", "serial:/dev/pts/9"]);
        assert_eq!(listed(&some, 1_000), []);
        for bus in &mut some.buses {
            bus.boards = vec![(0, KeyRange::parse("A0..G1").unwrap()); 8];
        }
        let plans = listed(&some, 1_000);
        assert_eq!(plans.iter().map(|it| it.name.as_str()).collect::<Vec<_>>(), ["can0"]);
        let said = sentences(&plans, BusVerdict::Refused);
        assert!(said[0].contains("would take") && said[0].contains("divide"), "{said:?}");
    }
}
