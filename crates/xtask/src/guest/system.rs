//! What runs in a guest beside the checks, and the machine that it needs.

/// The system of a guest.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub(crate) enum GuestSystem {
    /// Busybox, on files that are in the guest's memory.
    Busybox,
    /// systemd, on the files of this machine, which it reads; what it writes stays in its memory.
    Systemd,
}

impl GuestSystem {
    /// The script that is the first program of the guest.
    pub(super) const fn init(self) -> &'static str {
        match self {
            Self::Busybox => include_str!("init.sh"),
            Self::Systemd => include_str!("init_systemd.sh"),
        }
    }

    /// QEMU's arguments beyond those of every guest.
    ///
    /// Time in the guest is what its processor has executed, 1 ns an instruction, or has waited for:
    /// a busy machine makes the guest slow and not late. Where everything is in its memory nothing
    /// really waits; files of this machine are waited for, and so must be all else.
    pub(super) const fn machine(self) -> &'static str {
        match self {
            Self::Busybox => "-icount shift=0,sleep=off",
            Self::Systemd => {
                "-icount shift=0,sleep=on \
                 -virtfs local,path=/,mount_tag=this,security_model=none,readonly=on,multidevs=remap \
                 -device qemu-xhci -chardev null,id=port \
                 -device usb-serial,chardev=port,always-plugged=on"
            }
        }
    }
}
