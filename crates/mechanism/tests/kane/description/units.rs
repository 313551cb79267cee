use mechanism::kane::text::{Dimension, unit};

#[track_caller]
fn is(text: &str, number: f64, si: &str) {
    let unit = unit(text).expect("a unit");
    assert_eq!((unit.to_si(1.0), unit.si.as_str()), (number, si));
}

#[test]
fn usual_units_are_known() {
    is("m", 1.0, "m");
    is("mm", 1e-3, "m");
    is("kg", 1.0, "kg");
    is("g", 1e-3, "kg");
    is("gf", 9.80665e-3, "N");
    is("kN/m", 1e3, "N/m");
    is("N*m/rad", 1.0, "N·m/rad");
    is("N·m·s/rad", 1.0, "N·m·s/rad");
    is("kg*m^2", 1.0, "kg·m²");
    is("kg*cm²", 1e-4, "kg·m²");
    is("m/s^2", 1.0, "m/s²");
    is("1", 1.0, "1");
    is("1/ms", 1e3, "1/s");
    is("N/mm^2", 1e6, "N/m²");
    is("N/m^2.5", 1.0, "N/m^2.5");
    is("kg/(m*s)", 1.0, "kg/(m·s)");
    is("µm", 1e-6, "m");
    is("deg", std::f64::consts::PI / 180.0, "rad");
    is("min", 60.0, "s");
}

#[test]
fn what_is_no_unit_is_refused() {
    for text in ["", "mkg", "foo", "m*", "m/(s", "3 m", "kgg", "mdeg", "m^", "(((m)))", "'"] {
        assert!(unit(text).is_err(), "{text:?}");
    }
}

#[test]
fn a_decimal_number_in_a_prefixed_unit_is_rounded_once() {
    assert_eq!(unit("mm").expect("a unit").to_si(5.0), 0.005);
    assert_eq!(unit("g").expect("a unit").to_si(20.0), 0.02);
    assert_eq!(unit("kg").expect("a unit").to_si(6.2348e-5), 6.2348e-5);
}

#[test]
fn dimensions_are_written_as_people_do() {
    let (length, time) = (Dimension::LENGTH, Dimension::TIME);
    assert_eq!(Dimension::ENERGY.to_string(), "N·m");
    assert_eq!(Dimension::FORCE.over(length).to_string(), "N/m");
    assert_eq!(length.over(time.to(2.0)).to_string(), "m/s²");
    assert_eq!(length.to(0.5).to_string(), "m^0.5");
    assert_eq!(Dimension::MASS.over(length.times(time).times(time)).to_string(), "N/m²");
    assert_eq!(Dimension::NONE.to_string(), "1");
}
