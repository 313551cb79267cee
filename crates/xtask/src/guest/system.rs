//! The system of a guest.

#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub(crate) enum GuestSystem {
    /// Busybox with files in the guest's memory.
    Busybox,
    /// systemd with read access to the files of this machine; writes stay in memory.
    Systemd,
}

impl GuestSystem {
    pub(super) const fn init(self) -> &'static str {
        match self {
            Self::Busybox => include_str!("init.sh"),
            Self::Systemd => include_str!("init_systemd.sh"),
        }
    }

    /// Returns QEMU's arguments beyond the common ones. Guest time is executed instructions, 1 ns
    /// each, and waiting: a busy machine makes the guest slow but not late. With everything in
    /// memory nothing really waits; reading files of this machine does, and so must all else.
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
