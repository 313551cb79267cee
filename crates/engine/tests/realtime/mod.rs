//! Lanes and budgets on real threads.

mod budgets;
