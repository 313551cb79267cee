mod can;
mod conformance;
mod faulty;
mod serial_pty;
