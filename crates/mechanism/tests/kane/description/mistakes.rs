use mechanism::kane::description::{read, read_bytes, rendered};

use super::{WEIGHT, good, mistake, mistakes_of};

/// Replaces `old` by `new` in a valid description; the message must contain all `parts`.
#[track_caller]
fn says(old: &str, new: &str, parts: &[&str]) {
    let said = mistake(old, new);
    for part in parts {
        assert!(said.contains(part), "{said:?} lacks {part:?}");
    }
}

#[test]
fn an_unknown_name_has_the_nearest_known_one() {
    says("\"stretch'\"", "\"strech'\"", &["27:9", "there is no \"strech\"", "use \"stretch\""]);
    says("force(spring)", "force(sprong)", &["sprong", "use \"spring\""]);
    says("y(P)", "y(Q)", &["there is no point \"Q\"", "use \"P\""]);
    says(
        "reaction(wall)",
        "reaction(walls)",
        &["there is no constraint \"walls\"", "use \"wall\""],
    );
    says("in = \"W\"", "in = \"V\"", &["there is no frame \"V\"", "W"]);
    says("to = \"free\"", "to = \"fre\"", &["there is no mode \"fre\"", "use \"free\""]);
    says("mode = \"free\"", "mode = \"flying\"", &["there is no mode \"flying\"", "free"]);
    says("{ m = \"2 kg\" }", "{ mm = \"2 kg\" }", &["there is no parameter \"mm\""]);
    says("summary", "sumary", &["there is no key \"sumary\" here", "use \"summary\""]);
    says("stiffness = \"k\"", "stifness = \"k\"", &["stifness"]);
    says("\"y'\" = \"0 m/s\"", "\"z'\" = \"0 m/s\"", &["there is no coordinate or speed \"z'\""]);
    says(
        "reaction(wall)",
        "reation(wall)",
        &["there is no function \"reation\"", "use \"reaction\""],
    );
}

#[test]
fn units_that_do_not_fit_are_named_with_both_places() {
    says(
        "\"y - s\"",
        "\"y - 3 s\"",
        &[
            "\"3 s\" is in s, but \"y\" is in m",
            "(at line 26, column 12)",
            "26:16",
            "a sum takes one unit",
        ],
    );
    says("mass = \"m\"", "mass = \"k\"", &["\"mass\" is in N/m, not in kg"]);
    says(
        "mass = \"m\"",
        "mass = \"2\"",
        &["\"mass\" is in 1, not in kg", "write its unit, as \"2 kg\""],
    );
    says("stiffness = \"k\"", "stiffness = \"k*y(P)\"", &["cannot stand here"]);
    says("stiffness = \"k\"", "stiffness = \"m\"", &["\"stiffness\" is in kg, not in N/m"]);
    says("\"1 m - y\"", "\"sin(y)\"", &["\"y\" is in m, not a ratio or an angle"]);
    says("\"m > 0.1*m0\"", "\"m > k\"", &["\"k\" is in N/m, but \"m\" is in kg", "a comparison"]);
    says("\"0 m/s\"", "\"1 m\"", &["\"y'\" is in m, not in m/s"]);
}

#[test]
fn numbers_that_cannot_be_meant_are_named() {
    let damping = "damping = \"1 N*s/m\"";
    says(damping, "damping = \"-1 N*s/m\"", &["\"damping\" is negative", "[forces]"]);
    says("stiffness = \"k\"", "stiffness = \"1 N/m - k\"", &["\"stiffness\" is negative"]);
    says(
        "\"20 N/m\"",
        "20",
        &["16:15", "the value has no unit, but its range is in N/m", "as \"20 N/m\""],
    );
    let set = "set = { \"y'\" = \"0 m/s\" }";
    let impact = |words: &str| format!("impact = {{ along = {words} }}");
    says(set, &impact("\"1 m - y\", restitution = \"3*e\""), &["is outside 0 to 1"]);
    says(set, &impact("\"y - 1 m\""), &["direction opposed", "positive apart"]);
    good(&WEIGHT.replacen(set, &impact("\"1 m - y\", restitution = \"e\""), 1));
    let fast = "mode = \"free\"\n\"y'\" = \"1 m/s\"";
    says("mode = \"free\"", fast, &["what rests has none", "start = true"]);
    good(&WEIGHT.replacen("mode = \"free\"", &format!("{fast}\nstart = true"), 1));
    let start = "mode = \"leaning\"\nstart = true";
    says("mode = \"free\"", start, &["the start contradicts the constraint \"wall\""]);
    let felt =
        "[felts]\nf = { compression = \"y\", stiffness = \"1 s\", exponent = 1.5 }\n[constraints]";
    says("[constraints]", felt, &["not in N/m^1.5"]);
    let contact = |gap: &str| {
        let contact = format!("f = {{ gap = \"{gap}\", stiffness = \"k\" }}");
        let text =
            WEIGHT.replacen("[constraints]", &format!("[contacts]\n{contact}\n[constraints]"), 1);
        text.replacen("mode = \"free\"", "mode = \"free\"\nstart = true", 1)
    };
    good(&contact("y + 2 m"));
    let inside = mistakes_of(&contact("-1 m - y"), &());
    assert!(inside[0].contains("\"f\" begins 9.9") && inside.len() == 1, "{inside:?}");
}

#[test]
fn units_themselves_are_checked() {
    says("\"20 N/m\"", "\"20 Nm\"", &["\"Nm\" is no unit"]);
    says("unit = \"m\", range", "unit = \"mm\", range", &["\"mm\" is not in SI", "write m"]);
    says("unit = \"N\"", "unit = \"Newton\"", &["there is no unit \"Newton\""]);
}

#[test]
fn a_name_that_stands_twice_is_named_with_both_places() {
    says("fall = ", "k = ", &["27:1", "\"k\" is a name already (at line 16, column 1)"]);
    says("m0 = {", "m = {", &["15:1", "\"m\" stands here a second time"]);
}

#[test]
fn circles_are_shown_whole() {
    says(
        "stretch = \"y - s\"",
        "stretch = \"y - s + 1 s * fall\"",
        &["these are made of each other: stretch → fall → stretch"],
    );
    says(
        "{ m = \"2 kg\" }",
        "{ m = \"m0\", m0 = \"2*m\" }",
        &["the values depend on each other", "m → m0"],
    );
}

#[test]
fn a_guard_leads_somewhere() {
    says("to = \"leaning\"\n", "", &["the guard leads nowhere", "write to ="]);
}

#[test]
fn modes_can_be_reached_and_left() {
    let mistakes = mistakes_of(&WEIGHT.replacen("to = \"leaning\"", "to = \"free\"", 1), &());
    assert!(
        mistakes.iter().any(|it| it.contains("the mode \"leaning\" is unreachable")),
        "{mistakes:?}"
    );
    assert!(mistakes.iter().any(|it| it.contains("the mode \"free\" has no exit")), "{mistakes:?}");
    says(
        "to = \"free\"",
        "to = \"leaning\"",
        &["the mode \"leaning\" has no exit", "final = true"],
    );
    let lasting = WEIGHT.replacen("to = \"free\"", "to = \"leaning\"", 1);
    good(&lasting.replacen("[modes.leaning]", "[modes.leaning]\nfinal = true", 1));
}

#[test]
fn ranges_and_requirements_hold_on_every_key() {
    says(
        "0.1 g * key",
        "0.2 kg * key",
        &["\"m\" is 10.02 kg in preset \"light\" on key 50", "0.001 to 10 kg"],
    );
    says("\"20 g + 0.1 g * key\"", "\"20 g - 0.2 g * key\"", &["on key 50", "does not hold"]);
    says(
        "\"m > 0.1*m0\"",
        "\"m > 0.5*m0\"",
        &["\"m > 0.5*m0\" does not hold in preset \"light\" on key 0", "5:14"],
    );
}

#[test]
fn the_initial_pose_has_numbers() {
    says(
        "\"1 m - y\"",
        "\"1 m - y*(1 m)/(y - s + m*g/k)\"",
        &["at the initial pose", "division by zero"],
    );
    says("\"1 m - y\"", "\"1 m - y/0\"", &["division by zero"]);
    says(
        "y = \"s - m*g/k\"",
        "y = \"s - 9*m*g/k\"",
        &["\"y\" is -8.82", "out of its range of motion"],
    );
}

#[test]
fn what_is_no_expression_is_shown_where_it_ends() {
    says("\"y - s\"", "\"y - \"", &["26:16", "the expression ends too early"]);
    says("\"y - s\"", "\"(y - s\"", &["26:12", "this ( is not closed"]);
    says("\"y - s\"", "\"y s\"", &["26:14", "\"s\" is too much here"]);
    says("\"y - s\"", "\"y > s\"", &["a comparison stands only in requires"]);
    says("\"y - s\"", "\"y = s\"", &["\"=\" means nothing here"]);
    says("\"m > 0.1*m0\"", "\"m\"", &["a comparison is missing"]);
}

#[test]
fn what_cannot_stand_somewhere_is_said() {
    says(
        "y = \"s - m*g/k\"",
        "y = \"s - y\"",
        &["\"y\" depends on coordinates, which cannot stand here"],
    );
    says("fall = \"stretch'\"", "fall = \"k'*1 s\"", &["\"k\" is a parameter and has no rate"]);
    says("fall = \"stretch'\"", "fall = \"rate(force(spring))\"", &["the rate of", "is not known"]);
}

#[test]
fn what_should_be_linear_in_the_speeds_is() {
    let rolls = |zero: &str| {
        format!("roll = {{ zero = \"{zero}\", kind = \"nonholonomic\" }}\n\n[modes.free]")
    };
    for zero in ["y' - s'", "2*y'*cos(y/(1 m)) + if(y > s, y', 3*y') - 1 m/s"] {
        good(&WEIGHT.replacen("[modes.free]", &rolls(zero), 1));
    }
    for zero in ["y'*y'", "abs(y')", "y'^2/(1 m/s)", "1/y'", "if(y' > s', y', 2*y')"] {
        says("[modes.free]", &rolls(zero), &["\"roll\" is not linear in the speeds"]);
    }
}

#[test]
fn all_mistakes_come_at_once() {
    let text = WEIGHT
        .replacen("\"y - s\"", "\"y - z\"", 1)
        .replacen("to = \"free\"", "to = \"fre\"", 1)
        .replacen("mass = \"m\"", "mass = \"1 m\"", 1);
    let mistakes = mistakes_of(&text, &());
    assert_eq!(mistakes.len(), 3, "{mistakes:#?}");
}

#[test]
fn a_caret_stands_under_the_place() {
    let text = WEIGHT.replacen("\"y - s\"", "\"y - zz\"", 1);
    let mistakes = read("test.toml", &text, &()).expect_err("zz is unknown");
    let source = documents::toml::TomlSource { name: "test.toml".to_owned(), text };
    let shown = rendered(&mistakes, &[source]);
    assert!(shown.contains("\n  stretch = \"y - zz\"\n                 ^\n"), "{shown}");
}

#[test]
fn bytes_that_are_no_description_are_refused() {
    let mistakes = read_bytes("a.toml", b"name = \"x\"\n\xff", &()).expect_err("no text");
    assert!(mistakes.to_string().contains("not UTF-8 text from line 2 on"), "{mistakes}");
    let said = mistakes_of("<html>\n<body>", &());
    assert!(said.iter().any(|it| it.contains("this is not TOML")), "{said:?}");
    let said = mistakes_of("", &());
    assert!(said.iter().any(|it| it.contains("the description has no name")), "{said:?}");
}
