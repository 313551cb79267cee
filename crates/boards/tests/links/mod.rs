mod can;
mod faulty;
mod serial_pty;
