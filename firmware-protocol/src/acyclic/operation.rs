//! Types and functions that derive from the table of operations.

/// Defines [`super::Operation`], its entries for generated code, and the functions of a board.
macro_rules! define_operations {
    ($(
        $number:literal $name:ident = $function:ident($request:ty) -> $answer:ty,
        $needed:ident, $meaning:literal;
    )+) => {
        /// The purpose of a request. A board that lacks an operation answers [`Status::Unknown`].
        #[derive(Clone, Copy, PartialEq, Eq, PartialOrd, Ord, Debug)]
        #[repr(u8)]
        pub enum Operation {
            $(#[doc = $meaning] $name = $number,)+
        }

        impl Operation {
            pub const ALL: [Self; [$($number),+].len()] = [$(Self::$name),+];

            pub const fn new(number: u8) -> Option<Self> {
                match number {
                    $($number => Some(Self::$name),)+
                    _ => None,
                }
            }

            pub const fn entry(self) -> OperationEntry {
                match self {
                    $(Self::$name => OperationEntry {
                        function: stringify!($function),
                        needed: stringify!($needed),
                        request: <$request as Record>::LAYOUT,
                        answer: <$answer as Record>::LAYOUT,
                        meaning: $meaning,
                    },)+
                }
            }
        }

        /// The operations of a board. A missing one answers [`Status::Unknown`].
        pub trait BoardOperations {
            $(
                #[doc = $meaning]
                fn $function(&mut self, _request: $request) -> Result<$answer, Status> {
                    Err(Status::Unknown)
                }
            )+
        }

        /// Runs `request` on `board`, and encodes its reply; returns the length.
        pub fn answer(
            board: &mut impl BoardOperations,
            request: &AcyclicRequest<'_>,
            bytes: &mut [u8; MAX_FRAME],
        ) -> usize {
            let AcyclicRequest { board: number, id, operation, record } = *request;
            match operation {
                $(Ok(Operation::$name) => {
                    let record = <$request>::take(record).ok_or(Status::BadValue);
                    let outcome = record.and_then(|it| board.$function(it));
                    encode_reply(number, id, $number, outcome, bytes)
                })+
                Err(unknown) => {
                    let outcome = Err::<Nothing, _>(Status::Unknown);
                    encode_reply(number, id, unknown, outcome, bytes)
                }
            }
        }
    };
}
