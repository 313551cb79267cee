//! Requests of the edit layer that are not answered yet, in their order.

use std::collections::{BTreeMap, BTreeSet, VecDeque};
use std::ops::RangeInclusive;

use telemetry::{Request, request::Change, source::Ticket};

use super::edit::ParameterSlot;
use crate::names;

#[derive(Clone, Debug)]
struct InstrumentSwitch {
    name: String,
    keys: RangeInclusive<u8>,
    follows_base: bool,
}

/// Sent values with the revisions of their keys' voices at that time.
pub(super) type SentValues = BTreeMap<ParameterSlot, (f64, u32)>;

#[derive(Clone, Debug)]
pub(super) enum SentRequest {
    Switch(RangeInclusive<u8>),
    Values(SentValues),
}

/// Requests to send, and the one that was sent.
#[derive(Clone, Debug, Default)]
pub(super) struct RequestQueue {
    switches: VecDeque<InstrumentSwitch>,
    expected: BTreeMap<u8, String>,
    dirty: BTreeSet<ParameterSlot>,
    asked: Option<(Ticket, SentRequest)>,
}

impl RequestQueue {
    pub(super) fn switch(&mut self, name: &str, keys: RangeInclusive<u8>) {
        self.dirty.retain(|slot| !keys.contains(&slot.key));
        self.expected.extend(keys.clone().map(|key| (key, name.to_owned())));
        let name = name.to_owned();
        self.switches.push_back(InstrumentSwitch { name, keys, follows_base: false });
    }

    pub(super) fn follow_base(&mut self) {
        if let Some(last) = self.switches.back_mut() {
            last.follows_base = true;
        }
    }

    pub(super) fn mark(&mut self, slot: ParameterSlot) {
        self.dirty.insert(slot);
    }

    pub(super) fn expected(&self, key: u8) -> Option<&str> {
        self.expected.get(&key).map(String::as_str)
    }

    pub(super) fn awaits(&self, key: u8) -> bool {
        self.expected.contains_key(&key)
    }

    pub(super) fn expects(&self, key: u8, instrument: &str) -> bool {
        self.expected(key) == Some(instrument)
    }

    pub(super) fn arrived(&mut self, key: u8, instrument: &str) {
        let is_switched = |it: &InstrumentSwitch| it.keys.contains(&key);
        if self.expects(key, instrument) && !self.switches.iter().any(is_switched) {
            self.expected.remove(&key);
        }
    }

    pub(super) fn is_pending(&self, slot: &ParameterSlot) -> bool {
        let is_asked = matches!(&self.asked, Some((_, SentRequest::Values(values)))
            if values.contains_key(slot));
        is_asked || self.dirty.contains(slot)
    }

    pub(super) fn forget_key(&mut self, key: u8) {
        self.expected.remove(&key);
        self.dirty.retain(|slot| slot.key != key);
        if let Some((_, SentRequest::Values(values))) = &mut self.asked {
            values.retain(|slot, _| slot.key != key);
        }
    }

    pub(super) fn forget_keys(&mut self, keys: &RangeInclusive<u8>) {
        keys.clone().for_each(|key| self.forget_key(key));
    }

    fn sendable(&self) -> impl Iterator<Item = &ParameterSlot> {
        self.dirty.iter().filter(|slot| !self.awaits(slot.key))
    }

    pub(super) fn is_empty(&self) -> bool {
        self.switches.is_empty() && self.dirty.is_empty() && self.asked.is_none()
    }

    pub(super) fn lose(&mut self) {
        match self.asked.take() {
            None => {}
            Some((_, SentRequest::Values(values))) => self.dirty.extend(values.into_keys()),
            Some((_, SentRequest::Switch(keys))) => {
                if let Some(name) = self.expected(*keys.start()).map(str::to_owned) {
                    let switch = InstrumentSwitch { name, keys, follows_base: false };
                    self.switches.push_front(switch);
                }
            }
        }
    }

    pub(super) fn outgoing(
        &self,
        value: impl Fn(&ParameterSlot) -> Option<f64>,
    ) -> Option<Request> {
        if self.asked.is_some() {
            return None;
        }
        if let Some(InstrumentSwitch { name, keys, follows_base }) = self.switches.front() {
            let keys = (*keys != (0..=names::LAST)).then(|| names::range_name(keys));
            let instrument = name.clone();
            return Some(if *follows_base {
                Request::FollowBase { instrument, keys }
            } else {
                Request::UseInstrument { instrument, keys }
            });
        }
        let change = |slot: &ParameterSlot| {
            let parameter = slot.parameter.clone();
            Some(Change { key: slot.key, parameter, value: value(slot)? })
        };
        let changes: Vec<Change> = self.sendable().filter_map(change).collect();
        (!changes.is_empty()).then_some(Request::Set { changes })
    }

    /// Records that `ticket` sent the outgoing request, with the values and revisions of slots.
    pub(super) fn sent(
        &mut self,
        ticket: Ticket,
        value: impl Fn(&ParameterSlot) -> Option<(f64, u32)>,
    ) {
        let pending = if let Some(switch) = self.switches.pop_front() {
            SentRequest::Switch(switch.keys)
        } else {
            let slots: Vec<_> = self.sendable().cloned().collect();
            self.dirty.retain(|slot| !slots.contains(slot));
            let values = slots.into_iter().filter_map(|slot| {
                let value = value(&slot)?;
                Some((slot, value))
            });
            SentRequest::Values(values.collect())
        };
        self.asked = Some((ticket, pending));
    }

    pub(super) fn answered(&mut self, ticket: Ticket) -> Option<SentRequest> {
        self.asked.take_if(|(asked, _)| *asked == ticket).map(|(_, pending)| pending)
    }
}
