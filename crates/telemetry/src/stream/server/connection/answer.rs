//! Requests to the host, answered beside the runtime's thread.

use std::sync::{Arc, Mutex, PoisonError};

use tokio::{sync::mpsc, task::JoinHandle};
use tokio_tungstenite::tungstenite::Message;

use crate::stream::protocol::{FromServer, Level, ParameterError, ParameterValue, ServerFrame};
use crate::stream::server::{ParameterSetting, Who, outbox::Outbox, state::ServerState};
use crate::{Reply, Request};

#[derive(Debug)]
pub(super) struct PendingAnswer {
    pub(super) receipt: Receipt,
    pub(super) request: ClientRequest,
}

/// Address of an answer.
#[derive(Clone, Debug)]
pub(super) enum Receipt {
    Parameters(Option<String>),
    Call(u32, u32),
}

#[derive(Debug)]
pub(super) enum ClientRequest {
    Get(Vec<String>),
    Set(Vec<ParameterValue>),
    Call(Result<Request, String>),
}

impl PendingAnswer {
    /// Returns `true` if it overtakes others.
    pub(super) const fn is_urgent(&self) -> bool {
        matches!(self.request, ClientRequest::Call(Ok(Request::Stop {})))
    }

    /// Returns `true` if it takes seconds and changes nothing.
    const fn is_measurement(&self) -> bool {
        matches!(
            self.request,
            ClientRequest::Call(Ok(Request::Margin { .. } | Request::Figures { .. }))
        )
    }
}

impl Receipt {
    pub(super) fn refuse(self, outbox: &Outbox, message: String) {
        match self {
            Self::Parameters(id) => outbox.status(Level::Error, message, id),
            Self::Call(service_id, call_id) => {
                outbox.tell(&FromServer::ServiceCallFailure { service_id, call_id, message });
            }
        }
    }

    /// Answers with the reply; `values` are those that were requested or set.
    fn tell(self, outbox: &Outbox, values: &[ParameterSetting], reply: Option<Reply>) {
        let parameters = values.iter().map(|it| ParameterValue::new(it.name.clone(), it.value));
        match self {
            Self::Parameters(id) => {
                let parameters = parameters.collect();
                outbox.tell(&FromServer::ParameterValues { parameters, id, reply });
            }
            Self::Call(service, call) => {
                let payload = serde_json::to_vec(&reply).unwrap_or_default();
                let response =
                    ServerFrame::Response { service, call, encoding: "json", payload: &payload };
                outbox.send(Message::binary(response.encode()));
            }
        }
    }
}

#[derive(Clone)]
pub(super) struct Answerer(Arc<Parts>);

struct Parts {
    state: Arc<ServerState>,
    outbox: Arc<Outbox>,
    who: Who,
    /// `true` if the client is disconnected; locked while a key is pressed.
    is_gone: Mutex<bool>,
}

impl Answerer {
    pub(super) fn new(state: Arc<ServerState>, outbox: Arc<Outbox>, who: Who) -> Self {
        Self(Arc::new(Parts { state, outbox, who, is_gone: Mutex::new(false) }))
    }

    pub(super) fn arrive(&self) {
        self.0.state.backend.connected(&self.0.who);
    }

    /// Reports to the backend that the client is disconnected: its pressed keys are released.
    pub(super) fn leave(&self) {
        *self.0.is_gone.lock().unwrap_or_else(PoisonError::into_inner) = true;
        self.0.state.backend.disconnected(&self.0.who);
    }

    pub(super) async fn run(&self, mut pending: mpsc::Receiver<PendingAnswer>) {
        let mut measurement: Option<JoinHandle<()>> = None;
        while let Some(answer) = pending.recv().await {
            if !answer.is_measurement() {
                complete(Arc::clone(&self.0), answer).await;
                continue;
            }
            // One at a time, and other requests do not wait for it.
            if let Some(last) = measurement.take() {
                let _ended = last.await;
            }
            measurement = Some(tokio::spawn(complete(Arc::clone(&self.0), answer)));
        }
    }
}

/// Completes and publishes a request, even if its client disconnects.
async fn complete(parts: Arc<Parts>, answer: PendingAnswer) {
    let PendingAnswer { receipt, request } = answer;
    let (outbox, copy) = (Arc::clone(&parts.outbox), receipt.clone());
    let answered = tokio::task::spawn_blocking(move || parts.answer(copy, request)).await;
    if answered.is_err() {
        let text = "the host failed over this request: whether it was done is not known";
        receipt.refuse(&outbox, text.to_owned());
    }
}

impl Parts {
    fn answer(&self, receipt: Receipt, request: ClientRequest) {
        match request {
            ClientRequest::Get(names) => {
                let names = if names.is_empty() { None } else { Some(names.as_slice()) };
                receipt.tell(&self.outbox, &self.state.backend.parameters(names), None);
            }
            ClientRequest::Set(parameters) => self.set(receipt, &parameters),
            ClientRequest::Call(request) => match request.and_then(|request| self.ask(request)) {
                Ok(reply) => receipt.tell(&self.outbox, &[], Some(reply)),
                Err(refusal) => receipt.refuse(&self.outbox, refusal),
            },
        }
    }

    fn set(&self, receipt: Receipt, parameters: &[ParameterValue]) {
        let result = self.try_set(parameters);
        let names: Vec<String> = parameters.iter().map(|it| it.name.clone()).collect();
        let values = self.state.backend.parameters(Some(&names));
        let is_named = matches!(receipt, Receipt::Parameters(Some(_)));
        let reply = match result {
            Ok(reply) => Some(reply),
            Err(refusal) => {
                receipt.clone().refuse(&self.outbox, refusal);
                None
            }
        };
        // A rejected client gets the present values instead.
        if is_named {
            receipt.tell(&self.outbox, &values, reply);
        }
    }

    fn try_set(&self, parameters: &[ParameterValue]) -> Result<Reply, String> {
        let changes: Result<Vec<_>, ParameterError> =
            parameters.iter().map(ParameterValue::change).collect();
        let changes = changes.map_err(|refusal| refusal.to_string())?;
        if changes.is_empty() {
            return Err("nothing was set: name at least one parameter".to_owned());
        }
        self.ask(Request::Set { changes })
    }

    fn ask(&self, request: Request) -> Result<Reply, String> {
        self.who.role.check(&request)?;
        if !matches!(request, Request::Press { .. } | Request::Grip { .. }) {
            return self.state.backend.ask(request, &self.who);
        }
        // Locked to the end: a key pressed after its client's disconnection would stay pressed.
        let is_gone = self.is_gone.lock().unwrap_or_else(PoisonError::into_inner);
        if *is_gone {
            return Err("the key was not pressed: its client is gone".to_owned());
        }
        self.state.backend.ask(request, &self.who)
    }
}
