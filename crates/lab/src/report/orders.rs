//! Table of the observed orders.

use super::page::{Table, TableCell};
use crate::accuracy::{MeasuredScenario, observed_orders};

pub(super) const TEXT: &str = "The observed order is the slope of the error over the step, by \
    least squares in logarithms, without errors of rounding. It is the nominal one only as far as \
    the motion is smooth between located events; the limit by the contacts is that of ever shorter \
    steps.";

pub(super) fn table(measured: &[MeasuredScenario]) -> Table {
    const COLUMNS: [(&str, &str); 6] = [
        ("scenario", ""),
        ("method", "method"),
        ("order", "order"),
        ("order_bound", "limit by the contacts"),
        ("observed_of_events", "observed: event times"),
        ("observed_of_states", "states"),
    ];
    let number = |it: Option<f64>| TableCell::maybe(it.map(|it| (it * 100.0).round() / 100.0));
    let rows = measured.iter().flat_map(|scenario| {
        observed_orders(scenario).into_iter().map(|it| {
            let order = TableCell::Words(it.nominal.to_string());
            let [name, method] = [scenario.entry.name, it.method].map(TableCell::words);
            [name, method, order, number(it.bound), number(it.events), number(it.states)]
        })
    });
    Table::new(COLUMNS).with(rows.collect::<Vec<_>>())
}
