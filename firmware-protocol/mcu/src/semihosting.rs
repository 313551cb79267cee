//! Output for a debugger: QEMU, or a probe.

use core::arch::asm;

const WRITE: usize = 0x05;
const OPEN: usize = 0x01;
const EXIT: usize = 0x18;
const EXIT_EXTENDED: usize = 0x20;
/// "The application ended", and "a fault".
const ENDED: usize = 0x2_0026;
const FAULT: usize = 0x2_0023;

fn call(operation: usize, argument: usize) -> usize {
    let answer;
    // SAFETY: the breakpoint with 0xAB belongs to the debugger, which reads, and answers in r0;
    // the caller keeps the blocks alive that `argument` points to.
    unsafe { asm!("bkpt 0xAB", inlateout("r0") operation => answer, in("r1") argument) }
    answer
}

pub fn write(text: &str) {
    // ":tt", opened for writing, is the console.
    let name = b":tt\0";
    let open = [name.as_ptr().expose_provenance(), 4, name.len() - 1];
    let handle = call(OPEN, open.as_ptr().expose_provenance());
    let block = [handle, text.as_ptr().expose_provenance(), text.len()];
    call(WRITE, block.as_ptr().expose_provenance());
}

pub fn write_number(number: usize) {
    let mut digits = [0; 10];
    let (mut at, mut rest) = (digits.len(), number);
    while rest != 0 || at == digits.len() {
        at -= 1;
        digits[at] = b"0123456789"[rest % 10];
        rest /= 10;
    }
    write(core::str::from_utf8(&digits[at..]).unwrap_or_default());
}

pub fn exit(good: bool) -> ! {
    let block = [if good { ENDED } else { FAULT }, usize::from(!good)];
    call(EXIT_EXTENDED, block.as_ptr().expose_provenance());
    call(EXIT, block[0]);
    loop {
        core::hint::spin_loop();
    }
}
