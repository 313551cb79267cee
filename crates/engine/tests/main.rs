//! The loop on this machine's threads.

mod budgets;
