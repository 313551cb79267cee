pub use crate::role::Role;

use crate::{Request, stream::protocol::Service};

impl Role {
    /// Returns the least role that may send `request`.
    pub const fn for_request(request: &Request) -> Self {
        match Service::of(request) {
            Some(service) => Self::for_service(service),
            None if matches!(request, Request::Set { .. }) => Self::Tuner,
            None => Self::Owner,
        }
    }

    /// Returns the least role for `service`. Every client that sees a failure may stop the host.
    pub const fn for_service(service: Service) -> Self {
        match service {
            Service::Stop => Self::Viewer,
            Service::UseInstrument
            | Service::FollowBase
            | Service::Load
            | Service::Press
            | Service::Grip
            | Service::Margin
            | Service::Figures
            | Service::Identify
            | Service::Render => Self::Tuner,
            Service::SaveInstrument | Service::Scene | Service::Record => Self::Owner,
        }
    }

    pub fn check(self, request: &Request) -> Result<(), String> {
        let needed = Self::for_request(request);
        if self >= needed {
            return Ok(());
        }
        Err(format!(
            "a {} may not do this: connect with a token of the role {}",
            self.name(),
            needed.name()
        ))
    }
}
