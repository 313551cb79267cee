//! Binary messages: a byte with the kind, little-endian numbers, then a payload.

use super::ProtocolError;

const MESSAGE_DATA: u8 = 1;
const TIME: u8 = 2;
const SERVICE_REQUEST: u8 = 2;
const SERVICE_RESPONSE: u8 = 3;

/// A binary message from a server.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub enum ServerFrame<'a> {
    Message {
        /// Subscription, by the client's own number.
        subscription: u32,
        /// Time at which it was made (ns since 1970).
        at: u64,
        payload: &'a [u8],
    },
    /// Present time (ns since 1970).
    Time(u64),
    Response {
        service: u32,
        /// Call, by the client's own number.
        call: u32,
        /// Encoding of the payload, as `json`.
        encoding: &'a str,
        payload: &'a [u8],
    },
}

impl<'a> ServerFrame<'a> {
    pub fn encode(&self) -> Vec<u8> {
        match *self {
            Self::Message { subscription, at, payload } => {
                let mut bytes = Vec::with_capacity(13 + payload.len());
                bytes.push(MESSAGE_DATA);
                bytes.extend(subscription.to_le_bytes());
                bytes.extend(at.to_le_bytes());
                bytes.extend_from_slice(payload);
                bytes
            }
            Self::Time(at) => [&[TIME][..], &at.to_le_bytes()].concat(),
            Self::Response { service, call, encoding, payload } => {
                Exchange { service, call, encoding, payload }.encode(SERVICE_RESPONSE)
            }
        }
    }

    pub fn decode(bytes: &'a [u8]) -> Result<Self, ProtocolError> {
        let mut reader = BinaryReader::new(bytes)?;
        match reader.opcode {
            MESSAGE_DATA => Ok(Self::Message {
                subscription: reader.u32()?,
                at: reader.u64()?,
                payload: reader.rest,
            }),
            TIME => Ok(Self::Time(reader.u64()?)),
            SERVICE_RESPONSE => {
                let Exchange { service, call, encoding, payload } = Exchange::read(&mut reader)?;
                Ok(Self::Response { service, call, encoding, payload })
            }
            other => Err(ProtocolError::Opcode(other)),
        }
    }
}

/// A binary message from a client.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub enum ClientFrame<'a> {
    Request { service: u32, call: u32, encoding: &'a str, payload: &'a [u8] },
}

impl<'a> ClientFrame<'a> {
    pub fn encode(&self) -> Vec<u8> {
        let Self::Request { service, call, encoding, payload } = *self;
        Exchange { service, call, encoding, payload }.encode(SERVICE_REQUEST)
    }

    pub fn decode(bytes: &'a [u8]) -> Result<Self, ProtocolError> {
        let mut reader = BinaryReader::new(bytes)?;
        match reader.opcode {
            SERVICE_REQUEST => {
                let Exchange { service, call, encoding, payload } = Exchange::read(&mut reader)?;
                Ok(Self::Request { service, call, encoding, payload })
            }
            other => Err(ProtocolError::Opcode(other)),
        }
    }
}

struct Exchange<'a> {
    service: u32,
    call: u32,
    encoding: &'a str,
    payload: &'a [u8],
}

impl<'a> Exchange<'a> {
    fn encode(&self, opcode: u8) -> Vec<u8> {
        let mut bytes = Vec::with_capacity(13 + self.encoding.len() + self.payload.len());
        bytes.push(opcode);
        bytes.extend(self.service.to_le_bytes());
        bytes.extend(self.call.to_le_bytes());
        // Encodings are words; one of four gigabytes is none.
        let length = u32::try_from(self.encoding.len()).unwrap_or(0);
        bytes.extend(length.to_le_bytes());
        bytes.extend_from_slice(self.encoding.as_bytes());
        bytes.extend_from_slice(self.payload);
        bytes
    }

    fn read(reader: &mut BinaryReader<'a>) -> Result<Self, ProtocolError> {
        let (service, call, length) = (reader.u32()?, reader.u32()?, reader.u32()?);
        let encoding = usize::try_from(length).ok().and_then(|length| reader.take(length));
        let encoding = encoding.ok_or_else(|| reader.short())?;
        let Ok(encoding) = std::str::from_utf8(encoding) else {
            return Err(ProtocolError::Encoding);
        };
        Ok(Self { service, call, encoding, payload: reader.rest })
    }
}

struct BinaryReader<'a> {
    opcode: u8,
    bytes: usize,
    rest: &'a [u8],
}

impl<'a> BinaryReader<'a> {
    fn new(bytes: &'a [u8]) -> Result<Self, ProtocolError> {
        let (opcode, rest) = bytes.split_first().ok_or(ProtocolError::Empty)?;
        Ok(Self { opcode: *opcode, bytes: bytes.len(), rest })
    }

    fn take(&mut self, length: usize) -> Option<&'a [u8]> {
        let (taken, rest) = self.rest.split_at_checked(length)?;
        self.rest = rest;
        Some(taken)
    }

    fn u32(&mut self) -> Result<u32, ProtocolError> {
        self.number().map(u32::from_le_bytes)
    }

    fn u64(&mut self) -> Result<u64, ProtocolError> {
        self.number().map(u64::from_le_bytes)
    }

    fn number<const N: usize>(&mut self) -> Result<[u8; N], ProtocolError> {
        let bytes = self.take(N).and_then(|bytes| bytes.try_into().ok());
        bytes.ok_or_else(|| self.short())
    }

    const fn short(&self) -> ProtocolError {
        ProtocolError::Short { opcode: self.opcode, bytes: self.bytes }
    }
}

#[cfg(test)]
mod tests {
    use proptest::prelude::*;

    use super::*;

    #[test]
    fn a_message_is_as_the_protocol_says() {
        let frame = ServerFrame::Message { subscription: 0x0102, at: 3, payload: b"xy" };
        let bytes = [1, 2, 1, 0, 0, 3, 0, 0, 0, 0, 0, 0, 0, b'x', b'y'];
        assert_eq!(frame.encode(), bytes);
        assert_eq!(ServerFrame::decode(&bytes).expect("a message"), frame);
    }

    #[test]
    fn a_call_is_as_the_protocol_says() {
        let frame = ClientFrame::Request { service: 7, call: 8, encoding: "json", payload: b"{}" };
        let bytes = b"\x02\x07\0\0\0\x08\0\0\0\x04\0\0\0json{}";
        assert_eq!(frame.encode(), bytes);
        assert_eq!(ClientFrame::decode(bytes).expect("a call"), frame);
    }

    #[test]
    fn what_is_cut_off_is_refused() {
        let whole =
            ServerFrame::Response { service: 7, call: 8, encoding: "json", payload: b"" }.encode();
        for length in 0..whole.len() {
            assert!(ServerFrame::decode(&whole[..length]).is_err(), "{length}");
        }
        let lying = b"\x02\x07\0\0\0\x08\0\0\0\xff\xff\xff\xffjson{}";
        let refused = ClientFrame::decode(lying).expect_err("too short").to_string();
        assert_eq!(
            refused,
            "a binary message with opcode 2 came with 19 bytes, which is too short"
        );
    }

    proptest! {
        #[test]
        fn any_bytes_are_read_or_refused(bytes in prop::collection::vec(any::<u8>(), 0..64)) {
            if let Ok(frame) = ServerFrame::decode(&bytes)
                && !matches!(frame, ServerFrame::Time(_))
            {
                prop_assert_eq!(frame.encode(), bytes.clone());
            }
            if let Ok(frame) = ClientFrame::decode(&bytes) {
                prop_assert_eq!(frame.encode(), bytes);
            }
        }
    }
}
