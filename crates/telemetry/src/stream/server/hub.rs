//! The hub: clients, their subscriptions, and the distribution of samples.

use std::{collections::BTreeMap, sync::Arc};

use super::hub_handle::{ClientNumber, HubCommand, HubHandle, HubReceivers};
use super::{outbox::Outbox, sample::StreamSample, watched::WatchedParameters};
use crate::Topic;
use crate::stream::protocol::{FromServer, Level, ParameterValue, Subscription, topic_of};

/// The clients with their subscriptions, and the receivers of samples and commands.
#[derive(Debug)]
pub(super) struct Hub {
    handle: Arc<HubHandle>,
    receivers: HubReceivers,
    latest: BTreeMap<u16, StreamSample>,
    members: BTreeMap<ClientNumber, Member>,
}

#[derive(Debug)]
struct Member {
    outbox: Arc<Outbox>,
    follows: BTreeMap<Topic, u32>,
    watched: WatchedParameters,
}

impl Hub {
    pub(super) fn new() -> (Arc<HubHandle>, Self) {
        let (handle, receivers) = HubHandle::channel();
        let (latest, members) = (BTreeMap::new(), BTreeMap::new());
        (Arc::clone(&handle), Self { handle, receivers, latest, members })
    }

    /// Distributes samples until it is dropped.
    pub(super) async fn run(mut self) {
        loop {
            tokio::select! {
                Some(command) = self.receivers.commands.recv() => self.execute(command),
                Some(sample) = self.receivers.samples.recv() => self.take(&sample),
                () = self.handle.is_retained.notified() => self.take_retained(),
            }
        }
    }

    fn execute(&mut self, command: HubCommand) {
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
            HubCommand::Flush(done) => {
                while let Ok(sample) = self.receivers.samples.try_recv() {
                    self.take(&sample);
                }
                self.take_retained();
                let _gone = done.send(());
            }
        }
    }

    fn with(&mut self, number: ClientNumber, work: impl FnOnce(&mut Member)) {
        if let Some(member) = self.members.get_mut(&number) {
            work(member);
        }
    }

    fn leave(&mut self, number: ClientNumber) {
        let Some(member) = self.members.remove(&number) else { return };
        for topic in member.follows.keys() {
            self.handle.following.remove(*topic);
        }
    }

    fn subscribe(&mut self, number: ClientNumber, wanted: &[Subscription]) {
        let Some(member) = self.members.get_mut(&number) else { return };
        let mut refusals = Vec::new();
        for subscription in wanted {
            match member.follow(*subscription) {
                Ok(topic) => {
                    self.handle.following.add(topic);
                    member.catch_up(topic, &self.latest);
                }
                Err(refusal) => refusals.push(refusal),
            }
        }
        // One sentence for all, so that a long list of nonsense gets no long answer.
        if let Some(first) = refusals.first() {
            let text = format!("{first} ({} of {} refused)", refusals.len(), wanted.len());
            member.outbox.status(Level::Warning, text, None);
        }
    }

    fn unsubscribe(&mut self, number: ClientNumber, ids: &[u32]) {
        let Some(member) = self.members.get_mut(&number) else { return };
        for id in ids {
            if let Some(topic) = member.unfollow(*id) {
                self.handle.following.remove(topic);
            }
        }
    }

    fn take_retained(&mut self) {
        for sample in self.handle.take_retained().into_values() {
            self.take(&sample);
        }
    }

    fn take(&mut self, sample: &StreamSample) {
        if let Some((slot, order)) = sample.retained {
            let last = self.latest.get(&slot).and_then(|last| last.retained);
            // A sample put aside may have overtaken those that waited in the queue.
            if last.is_some_and(|(_, last)| last > order) {
                return;
            }
            self.latest.insert(slot, sample.clone());
        }
        self.distribute(sample);
    }

    fn distribute(&self, sample: &StreamSample) {
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

    /// Sends the last retained samples of `topic` to a client that follows it now.
    fn catch_up(&self, topic: Topic, latest: &BTreeMap<u16, StreamSample>) {
        let Some(subscription) = self.follows.get(&topic) else { return };
        let mut samples: Vec<_> = latest.values().filter(|it| it.topic == topic).collect();
        // Slots of log lines are used again and again.
        samples.sort_by_key(|sample| sample.retained.map(|(_slot, order)| order));
        for sample in samples {
            self.outbox.post(*subscription, sample.clone());
        }
    }
}
