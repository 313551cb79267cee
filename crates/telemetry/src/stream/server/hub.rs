//! Who is there and follows what; hands out what comes in.

use std::collections::BTreeMap;
use std::sync::Arc;

use tokio::sync::mpsc;

use super::outbox::Outbox;
use super::publisher::HubHandle;
use super::sample::StreamSample;
use super::watched::WatchedParameters;
use crate::Topic;
use crate::stream::protocol::{FromServer, Level, ParameterValue, Subscription, topic_of};

/// Counts the clients of a run.
pub(super) type Number = u64;

/// What the hub is told.
#[derive(Debug)]
pub(super) enum HubCommand {
    Join(Number, Arc<Outbox>),
    Leave(Number),
    Subscribe(Number, Vec<Subscription>),
    /// Somebody wants no more messages.
    Unsubscribe(Number, Vec<u32>),
    /// Somebody wants to hear of parameters.
    Watch(Number, Vec<String>),
    /// Somebody wants to hear no more of parameters.
    Unwatch(Number, Vec<String>),
    /// Parameters have these values now.
    Changed(Vec<ParameterValue>),
}

/// Who is there and follows what.
#[derive(Debug)]
pub(super) struct Hub {
    desk: Arc<HubHandle>,
    samples: mpsc::Receiver<StreamSample>,
    commands: mpsc::UnboundedReceiver<HubCommand>,
    /// The last of each that every client gets.
    latest: BTreeMap<u16, StreamSample>,
    members: BTreeMap<Number, Member>,
}

/// Somebody who is there.
#[derive(Debug)]
struct Member {
    outbox: Arc<Outbox>,
    /// What they follow, and their own number for it.
    follows: BTreeMap<Topic, u32>,
    watched: WatchedParameters,
}

impl Hub {
    /// Nobody is there.
    pub(super) fn new(
        desk: Arc<HubHandle>,
        samples: mpsc::Receiver<StreamSample>,
        commands: mpsc::UnboundedReceiver<HubCommand>,
    ) -> Self {
        Self { desk, samples, commands, latest: BTreeMap::new(), members: BTreeMap::new() }
    }

    /// Hands out, until it is dropped.
    pub(super) async fn run(mut self) {
        loop {
            tokio::select! {
                Some(command) = self.commands.recv() => self.obey(command),
                Some(sample) = self.samples.recv() => self.take(&sample),
                () = self.desk.is_latched.notified() => self.take_latched(),
            }
        }
    }

    fn obey(&mut self, command: HubCommand) {
        match command {
            HubCommand::Join(number, outbox) => {
                let (follows, watched) = (BTreeMap::new(), WatchedParameters::none());
                self.members.insert(number, Member { outbox, follows, watched });
            }
            HubCommand::Leave(number) => self.leave(number),
            HubCommand::Subscribe(number, wanted) => self.subscribe(number, &wanted),
            HubCommand::Unsubscribe(number, ids) => self.unsubscribe(number, &ids),
            HubCommand::Watch(number, names) => {
                self.with(number, |member| member.watched.add(names));
            }
            HubCommand::Unwatch(number, names) => {
                self.with(number, |member| member.watched.remove(&names));
            }
            HubCommand::Changed(parameters) => self.tell_changed(&parameters),
        }
    }

    fn with(&mut self, number: Number, work: impl FnOnce(&mut Member)) {
        if let Some(member) = self.members.get_mut(&number) {
            work(member);
        }
    }

    fn leave(&mut self, number: Number) {
        let Some(member) = self.members.remove(&number) else { return };
        for topic in member.follows.keys() {
            self.desk.following.remove(*topic);
        }
    }

    fn subscribe(&mut self, number: Number, wanted: &[Subscription]) {
        let Some(member) = self.members.get_mut(&number) else { return };
        let mut refusals = Vec::new();
        for subscription in wanted {
            match member.follow(*subscription) {
                Ok(topic) => {
                    self.desk.following.add(topic);
                    member.catch_up(topic, &self.latest);
                }
                Err(refusal) => refusals.push(refusal),
            }
        }
        // One sentence for all, or a long list of nonsense would be answered at length.
        if let Some(first) = refusals.first() {
            let text = format!("{first} ({} of {} refused)", refusals.len(), wanted.len());
            member.outbox.status(Level::Warning, text, None);
        }
    }

    fn unsubscribe(&mut self, number: Number, ids: &[u32]) {
        let Some(member) = self.members.get_mut(&number) else { return };
        for id in ids {
            if let Some(topic) = member.unfollow(*id) {
                self.desk.following.remove(topic);
            }
        }
    }

    /// What found no room in the queue.
    fn take_latched(&mut self) {
        for sample in self.desk.take_latched().into_values() {
            self.take(&sample);
        }
    }

    fn take(&mut self, sample: &StreamSample) {
        if let Some((number, order)) = sample.latch {
            let last = self.latest.get(&number).and_then(|last| last.latch);
            // What was put aside may have overtaken what still waited in the queue.
            if last.is_some_and(|(_, last)| last > order) {
                return;
            }
            self.latest.insert(number, sample.clone());
        }
        self.hand_out(sample);
    }

    fn hand_out(&self, sample: &StreamSample) {
        for member in self.members.values() {
            if let Some(subscription) = member.follows.get(&sample.topic) {
                member.outbox.post(*subscription, sample.clone());
            }
        }
    }

    fn tell_changed(&self, changed: &[ParameterValue]) {
        for member in self.members.values() {
            let parameters = member.watched.of(changed);
            if !parameters.is_empty() {
                let message = FromServer::ParameterValues { parameters, id: None, reply: None };
                member.outbox.tell(&message);
            }
        }
    }
}

impl Member {
    fn follow(&mut self, wanted: Subscription) -> Result<Topic, String> {
        let Subscription { id, channel_id } = wanted;
        let Some(topic) = topic_of(channel_id) else {
            return Err(format!("subscription {id} is refused: there is no channel {channel_id}"));
        };
        if self.follows.contains_key(&topic) {
            return Err(format!("subscription {id} is refused: {topic} is subscribed to already"));
        }
        if self.follows.values().any(|taken| *taken == id) {
            return Err(format!("subscription {id} is refused: the number is taken"));
        }
        self.follows.insert(topic, id);
        Ok(topic)
    }

    fn unfollow(&mut self, id: u32) -> Option<Topic> {
        let topic =
            self.follows.iter().find(|(_, taken)| **taken == id).map(|(topic, _)| *topic)?;
        let _its_id = self.follows.remove(&topic);
        self.outbox.forget(id);
        Some(topic)
    }

    /// Whoever comes late gets the last of what is always there.
    fn catch_up(&self, topic: Topic, latest: &BTreeMap<u16, StreamSample>) {
        let Some(subscription) = self.follows.get(&topic) else { return };
        for sample in latest.values().filter(|sample| sample.topic == topic) {
            self.outbox.post(*subscription, sample.clone());
        }
    }
}
