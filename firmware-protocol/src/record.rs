//! Fixed records: fields one after the other, little-endian, without gaps.
//!
//! [`record!`] is the only list of a record's fields; reading, writing, the C header and the
//! tables of PROTOCOL.md derive from it.

/// A record in a frame.
pub trait Record: Sized + Copy {
    const LEN: usize;
    /// Name and fields, for generated code and documents.
    const LAYOUT: RecordLayout;

    /// Writes the record to the start of `bytes`; `None` without room.
    fn put(&self, bytes: &mut [u8]) -> Option<usize>;

    /// Decodes the record at the start of `bytes`, if long enough; a newer version may have more.
    fn take(bytes: &[u8]) -> Option<Self>;
}

/// Name and fields of a record in the order of the wire.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub struct RecordLayout {
    pub name: &'static str,
    pub fields: &'static [RecordField],
}

/// A field of a record, for generated code.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub struct RecordField {
    pub name: &'static str,
    /// Documentation of the field, which PROTOCOL.md prints.
    pub meaning: &'static str,
    /// Type in C99: `uint16_t`; bytes are an array of `uint8_t`.
    pub c_type: &'static str,
    pub len: usize,
}

pub(crate) trait Scalar: Sized + Copy {
    const LEN: usize;
    const C_TYPE: &'static str;
    /// Writes the scalar to the start of `bytes`, which must have room for it.
    fn put(self, bytes: &mut [u8]);
    fn take(bytes: &[u8]) -> Option<Self>;
}

macro_rules! scalars {
    ($($type:ty: $name:literal),+) => {$(
        impl Scalar for $type {
            const LEN: usize = size_of::<Self>();
            const C_TYPE: &'static str = $name;

            fn put(self, bytes: &mut [u8]) {
                bytes.copy_from_slice(&self.to_le_bytes());
            }

            fn take(bytes: &[u8]) -> Option<Self> {
                Some(Self::from_le_bytes(bytes.try_into().ok()?))
            }
        }
    )+};
}

scalars!(
    u8: "uint8_t", u16: "uint16_t", u32: "uint32_t", u64: "uint64_t", i16: "int16_t", i32: "int32_t"
);

impl<const N: usize> Scalar for [u8; N] {
    const LEN: usize = N;
    const C_TYPE: &'static str = "uint8_t[]";

    fn put(self, bytes: &mut [u8]) {
        bytes.copy_from_slice(&self);
    }

    fn take(bytes: &[u8]) -> Option<Self> {
        bytes.try_into().ok()
    }
}

/// Defines a record: a struct with its fields in the order of the wire. PROTOCOL.md prints the
/// comments of the fields, with units in square brackets.
macro_rules! record {
    (
        $(#[$doc:meta])+
        $name:ident { $($(#[doc = $meaning:literal])+ $field:ident: $type:ty,)* }
    ) => {
        $(#[$doc])+
        #[derive(Clone, Copy, PartialEq, Eq, Debug)]
        pub struct $name {
            $($(#[doc = $meaning])+ pub $field: $type,)*
        }

        impl $crate::Record for $name {
            const LEN: usize = 0 $(+ <$type as $crate::record::Scalar>::LEN)*;
            const LAYOUT: $crate::RecordLayout = $crate::RecordLayout {
                name: stringify!($name),
                fields: &[$($crate::RecordField {
                    name: stringify!($field),
                    meaning: concat!($($meaning),+),
                    c_type: <$type as $crate::record::Scalar>::C_TYPE,
                    len: <$type as $crate::record::Scalar>::LEN,
                },)*],
            };

            fn put(&self, bytes: &mut [u8]) -> Option<usize> {
                let rest = bytes.get_mut(..<Self as $crate::Record>::LEN)?;
                $(let rest = $crate::record::put(self.$field, rest)?;)*
                debug_assert!(rest.is_empty(), "the length is the sum of the fields");
                Some(<Self as $crate::Record>::LEN)
            }

            fn take(bytes: &[u8]) -> Option<Self> {
                let mut rest = bytes.get(..<Self as $crate::Record>::LEN)?;
                Some(Self { $($field: $crate::record::take(&mut rest)?,)* })
            }
        }
    };
}

/// Writes `value` to the start of `bytes`; returns the rest.
pub(crate) fn put<S: Scalar>(value: S, bytes: &mut [u8]) -> Option<&mut [u8]> {
    let (place, rest) = bytes.split_at_mut_checked(S::LEN)?;
    value.put(place);
    Some(rest)
}

/// Decodes a value from the start of `rest`, and removes its bytes.
pub(crate) fn take<S: Scalar>(rest: &mut &[u8]) -> Option<S> {
    S::take(rest.split_off(..S::LEN)?)
}

/// A record without fields.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub struct Nothing;

impl Record for Nothing {
    const LEN: usize = 0;
    const LAYOUT: RecordLayout = RecordLayout { name: "Nothing", fields: &[] };

    fn put(&self, _bytes: &mut [u8]) -> Option<usize> {
        Some(0)
    }

    fn take(_bytes: &[u8]) -> Option<Self> {
        Some(Self)
    }
}
