//! Tables of any numbers: what is read, and what the messages say.

use solaris_io::{Table, csv, sto};

fn read(text: &str) -> Table {
    csv::read_table(text).expect("a table")
}

#[test]
fn a_table_reads_back_bit_for_bit() {
    let numbers = [0.0, -0.0, 1.0 / 3.0, 5e-324, f64::MAX, -1e-7, 0.1 + 0.2, 12345.678, 1e16, 7.0];
    let columns = ["time", "left, of \"it\"", "größe", "a b", "c"].map(str::to_owned).to_vec();
    let table =
        Table { columns, values: numbers.to_vec(), lines: vec![2, 3], header_line: 1, ..Table::default() };
    let mut text = Vec::new();
    csv::write_table(&table, &mut text).expect("finite numbers");
    let back = read(&String::from_utf8(text).expect("text"));
    let bits = |table: &Table| table.values.iter().map(|x| x.to_bits()).collect::<Vec<_>>();
    assert_eq!(bits(&back), bits(&table));
    assert_eq!(back, table);
}

#[test]
fn line_ends_marks_quotes_and_spaces_do_not_matter() {
    let plain = read("time,a.q\n0,1\n0.5,2e-3\n");
    assert_eq!(plain.values, [0.0, 1.0, 0.5, 0.002]);
    let others = [
        "\u{feff}time,a.q\r\n0,1\r\n0.5,2e-3\r\n",
        "\"time\",\"a.q\"\n\"0\",\"1\"\n0.5,2E-3",
        " time , a.q \n 0 , +1 \n 0.5 , .002 \n",
    ];
    for text in others {
        assert_eq!(read(text), plain, "{text:?}");
    }
    let blank = read("\n\ntime,a.q\n\n0,1\n\n0.5,2e-3\n\n");
    assert_eq!((blank.values, blank.header_line, blank.lines), (plain.values, 3, vec![5, 7]));
    assert_eq!((plain.header_line, plain.lines), (1, vec![2, 3]));
    assert!(read("time,a.q\n").is_empty());
}

#[test]
fn mistakes_are_answered_with_line_and_column() {
    let long = format!("time,a\n0,{}\n", "9x".repeat(60));
    let wide: Vec<String> = (0..50_000).map(|i| format!("c{i}")).collect();
    let cases = [
        "",
        "\u{feff}",
        "\n\r\n\n",
        "time;a.q\n0;1\n",
        "time\ta.q\n0\t1\n",
        "time,a,,b\n0,1,2,3\n",
        "time,a,\n0,1,\n",
        "time,a,time\n0,1,2\n",
        "time,a\n0,1\n0.1\n",
        "time,a\n0,1\n0.1,2,3\n",
        "time,a\n0,1\n0.1,2\n0.2,1e999\n",
        "time,a\r\n0,1\r\n0.1,NaN\r\n",
        "time,a\n0,-inf\n",
        "time,a\n0,\n",
        "time,a\n0,1,5\n",
        "time,a\n0,0x10\n",
        "time,a\n0,\"1\n2\"\n",
        "time,\"a\n0,1\n",
        "\u{0}\u{1}\u{2}PNG\u{0},\u{7}\n\u{0},\u{1}\n",
        "# walk\ntime,a\n0,1\n",
        &long,
        &format!("{}\n1\n", wide.join(",")),
    ];
    let answer = |text: &str| match csv::read_table(text) {
        Ok(_) => "ACCEPTED".to_owned(),
        Err(error) => error.to_string(),
    };
    insta::assert_snapshot!(cases.map(answer).join("\n"));
}

#[test]
fn what_csv_cannot_say_is_not_written() {
    let columns = vec!["time".to_owned(), "knee".to_owned()];
    let table = |value, in_degrees| Table {
        columns: columns.clone(),
        values: vec![0.25, value],
        lines: vec![2],
        in_degrees,
        ..Table::default()
    };
    let error =
        |table: Table| csv::write_table(&table, &mut Vec::new()).expect_err("not for CSV").to_string();
    assert_eq!(error(table(f64::NAN, None)), "'knee' at 0.25 s is NaN; a file holds finite numbers only");
    assert!(error(table(1.0, Some(true))).contains("inDegrees=yes"));
    assert!(csv::write_table(&table(1.0, Some(false)), &mut Vec::new()).is_ok());
    // A table of OpenSim may have it, nothing that is written to be read.
    let twice = vec!["time".to_owned(), "time".to_owned()];
    assert!(
        error(Table { columns: twice, ..table(1.0, None) })
            .contains("'time' is also the heading of column 1")
    );
}

/// Rows of more fields than are kept are refused by their number, in all readers of tables.
#[test]
fn too_many_columns_are_refused() {
    let many = "a,".repeat(1_000_001);
    let told = "has 1000002 fields; at most 1000000 are read";
    assert!(csv::read_table(&many).expect_err("many").to_string().contains(told));
    assert!(csv::read_rows(&format!("a\n{many}")).expect_err("many").to_string().contains(told));
    let many = format!("endheader\ntime {}", "a ".repeat(1_000_001));
    assert!(sto::read(&many).expect_err("many").to_string().contains(told));
    let many = format!("DataType=Vec3\nendheader\ntime a\n0 {}1\n", "1,".repeat(1_000_000));
    assert!(sto::read(&many).expect_err("many").to_string().contains(told));
}

/// A million numbers in a second or so, and no more memory than a few times the numbers.
#[test]
fn long_tables_are_read_in_proportion() {
    let rows: Vec<String> = (0..200_000).map(|i| format!("{i},0.1,-0.25,3e-5,{i}")).collect();
    let text = format!("time,a,b,c,d\n{}\n", rows.join("\n"));
    let start = std::time::Instant::now();
    assert_eq!(read(&text).len(), 200_000);
    assert!(start.elapsed().as_secs() < 20);
}

/// A table of one row with this column beside the times.
fn headed(columns: [&str; 2]) -> Table {
    let columns = columns.map(str::to_owned).to_vec();
    Table { columns, values: vec![0.0, 1.0], lines: vec![2], header_line: 1, ..Table::default() }
}

#[test]
fn headings_with_marks_and_line_ends_are_read_back_or_not_written() {
    for name in [
        "\u{feff}time",
        "time\u{feff}",
        "a\rb",
        "a\nb",
        "a\r",
        " a",
        "a\u{85}",
        "\u{2028}a",
        "a\u{feff}b",
        "a,\"b\"",
    ] {
        let table = headed([name, "b"]);
        let mut text = Vec::new();
        match csv::write_table(&table, &mut text) {
            Ok(()) => {
                assert_eq!(
                    read(std::str::from_utf8(&text).expect("text")).columns,
                    table.columns,
                    "{name:?}"
                );
            }
            Err(error) => assert!(!["a\u{feff}b", "a,\"b\""].contains(&name), "{name:?}: {error}"),
        }
        let table = headed(["time", name]);
        let mut text = Vec::new();
        if sto::write(&table, &mut text).is_ok() {
            let back = sto::read(std::str::from_utf8(&text).expect("text")).expect("a table");
            assert_eq!(back.columns, table.columns, "{name:?}");
        }
    }
    let mut text = Vec::new();
    let error = csv::write_table(&headed(["\u{feff}time", "a"]), &mut text).expect_err("a mark");
    assert!(error.to_string().contains("cannot be a name in CSV"), "{error}");
}

#[test]
fn marks_that_files_put_together_leave_inside_are_no_part_of_a_heading() {
    assert_eq!(read("\u{feff}\u{feff}time,\u{feff}a\n0,1\n").columns, ["time", "a"]);
    assert_eq!(read("\u{feff}\"\u{feff}time\",a\u{feff}\n0,1\n").columns, ["time", "a"]);
    let text = "\u{feff}\u{feff}title\nversion=1\nendheader\n\u{feff}time\ta\u{feff}\n0\t1\n";
    let table = sto::read(text).expect("a table");
    assert_eq!(
        (table.title.as_str(), &table.columns[..]),
        ("title", &["time".to_owned(), "a".to_owned()][..])
    );
    let table = Table { title: "\u{feff}title\r\n x".to_owned(), ..headed(["time", "a"]) };
    let mut text = Vec::new();
    sto::write(&table, &mut text).expect("written");
    assert_eq!(sto::read(std::str::from_utf8(&text).expect("text")).expect("a table").title, "title x");
}

#[test]
fn a_motion_with_a_line_end_in_a_name_is_not_written_to_csv() {
    use solaris_model::{FigureBuilder, Joint, LinkSpec, Motion, MotionInfo};
    for name in ["\u{feff}a", "a\rb", " a"] {
        let link = LinkSpec::root("link", Joint::new("j").rx().named(name)).mass(1.0);
        let figure = FigureBuilder::new("f").link(link).build().expect("valid");
        let columns = [vec![0.0], vec![0.0], vec![0.0]];
        let motion =
            Motion::new(&figure, MotionInfo::on_earth(&figure, 1.0), vec![0.0], columns).expect("a motion");
        let error = csv::write(&figure, &motion, &mut Vec::new()).expect_err(name);
        assert!(error.to_string().contains("rename it"), "{error}");
    }
}
