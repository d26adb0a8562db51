//! A table beside other processes and on a real disk: two writers, a full disk, no locks, signals.

use super::*;
use crate::output_after_signal;

/// True if a process is stopped by a signal.
fn is_stopped(process: u32) -> bool {
    let state = Command::new("ps").args(["-o", "state=", "-p", &process.to_string()]).output().unwrap();
    text(&state.stdout).trim().starts_with('T')
}

/// The first writer stops after its first change of the disk, then after its second, and so on. Each time a second writer makes the
/// same table meanwhile, and the first one then continues: neither is refused, and nothing is lost.
#[test]
fn concurrent_writers_succeed() {
    let stop = Command::new("bash").args(["-c", "kill -l STOP"]).output().unwrap();
    let stop = text(&stop.stdout).trim().to_owned();
    let desk = Sandbox::with(random().replace("12000", "8"));
    for (rows, format) in FORMATS.into_iter().flat_map(|format| [None, Some(2)].map(|rows| (rows, format))) {
        let more = ["--format", format];
        ends(run(&desk, "alone", rows, &more), 0);
        for change in 1.. {
            let mut command = run(&desk, "out", rows, &more);
            let mut first = command.env("PLM_IMPACT_TEST_SIGNAL", format!("{stop}@{change}")).spawn().unwrap();
            let process = first.id();
            crate::wait(&mut first, || is_stopped(process));
            let is_through = first.try_wait().unwrap().is_some();
            ends(run(&desk, "out", rows, &more), 0);
            Command::new("kill").args(["-CONT", &process.to_string()]).stderr(Stdio::null()).status().unwrap();
            let output = first.wait_with_output().unwrap();
            let after = format!("{rows:?} {format}, change {change}");
            assert_eq!(output.status.code(), Some(0), "{after}: {}", text(&output.stderr));
            assert!(bytes(&desk, "out") == bytes(&desk, "alone"), "{after}");
            assert_eq!(summary(&desk, "out"), summary(&desk, "alone"), "{after}");
            assert_eq!(desk.files("out"), desk.files("alone"), "{after}");
            fs::remove_dir_all(desk.path("out")).unwrap();
            if is_through {
                assert!(change > 4, "{after}");
                break;
            }
        }
        fs::remove_dir_all(desk.path("alone")).unwrap();
    }
}

/// A limit on the size of files acts as a full disk for a table of one file. Its signal is ignored, so that writing fails
/// with an error.
#[test]
fn failed_write_ends_with_1_without_leftovers() {
    let desk = Sandbox::with(random());
    let script = "trap '' XFSZ; ulimit -f 400; exec \"$0\" run s.toml --out out --quiet";
    let mut command = Command::new("bash");
    let output = command.args(["-c", script, PROGRAM]).current_dir(desk.path("")).output().unwrap();
    assert_eq!(output.status.code(), Some(1), "{}", text(&output.stderr));
    assert!(text(&output.stderr).contains("free space"), "{}", text(&output.stderr));
    assert!(!desk.path("out").exists());
}

#[test]
fn full_disk_fails_and_the_command_resumes() {
    for format in FORMATS {
        // with all columns, or the disk is not filled
        let desk = Sandbox::with(random().replace("12000", "90000").replace("columns =", "#columns ="));
        fs::create_dir(desk.path("disk")).unwrap();
        let mount = |options: &str| {
            Command::new("mount").args(["-t", "tmpfs", "-o", options, "tmpfs"]).arg(desk.path("disk")).output()
        };
        if !mount("size=4m").is_ok_and(|done| done.status.success()) {
            skip("a full disk", "No disk of 4 MB can be mounted here: that takes root.");
            return;
        }
        let more = ["--format", format];
        let message = ends(run(&desk, "disk/out", Some(1000), &more), 1);
        assert!(message.contains("No space left") && message.contains("free space"), "{message}");
        let parts = desk.files("disk/out/parts").len();
        assert!(mount("remount,size=64m").unwrap().status.success());
        ends(run(&desk, "disk/out", Some(1000), &more), 0);
        ends(run(&desk, "alone", Some(1000), &more), 0);
        let is_same = bytes(&desk, "disk/out") == bytes(&desk, "alone");
        assert!(Command::new("umount").arg(desk.path("disk")).status().unwrap().success());
        assert!(is_same && parts > 10, "{parts}");
    }
}

/// On many clusters the file system knows no locks, and a summary says that the files beside it are of the same run.
#[test]
fn nothing_is_locked_and_the_summary_comes_last() {
    let desk = Sandbox::with(STEEL);
    let trace = |arguments: &[&str]| {
        let mut command = Command::new("strace");
        command
            .args(["-f", "-e", "trace=flock,fcntl,rename,renameat,renameat2", "-o", "calls", PROGRAM])
            .args(arguments);
        command.current_dir(desk.path("")).output()
    };
    if !trace(&["run", "s.toml", "--out", "out"]).is_ok_and(|done| done.status.success()) {
        skip("no file is locked", "The program strace is not here, or may not be used.");
        return;
    }
    let calls = desk.read("calls");
    assert!(!calls.contains("flock(") && !calls.contains("F_SETLK"), "{calls}");
    let renamed: Vec<&str> = calls.lines().filter(|line| line.contains("rename")).collect();
    assert!(renamed.len() > 3 && renamed.last().unwrap().contains("summary.json\""), "{calls}");
    fs::write(desk.path("s.toml"), grid()).unwrap();
    assert!(trace(&["run", "s.toml", "--out", "table", "--shard", "0/1"]).unwrap().status.success());
    assert!(!desk.read("calls").contains("flock("));
}

/// Rows that take a millisecond and more: velocity Verlet with very many steps. All of them would take a minute in one file, and days
/// in parts.
#[test]
fn signals_between_slow_rows_are_reported_correctly() {
    let signals = [("-INT", 130), ("-TERM", 143)];
    for (format, (signal, want)) in FORMATS.into_iter().flat_map(|format| signals.map(|signal| (format, signal))) {
        for (points, rows, folder, says) in [
            (20_000, Some(1250), "out", "Run the same command again"),
            (100_000_000, None, "out/parts", "again to resume"),
        ] {
            let desk = Sandbox::with(format!(
                "{STEEL}[solver]\nmethod = \"verlet\"\nsteps_per_contact = 20000\n[sweep]\n\"impact.speed\" = {{ logspace = [0.1, 1], points = {points} }}\n"
            ));
            let child = run(&desk, "out", rows, &["--format", format, "--threads", "1"]).spawn().unwrap();
            // the first hidden file is begun when the first rows are done
            let is_begun = |name: &String| name.starts_with('.') && !name.contains("trial");
            let is_at_work = || desk.path(folder).exists() && desk.files(folder).iter().any(is_begun);
            let output = output_after_signal(child, is_at_work, signal);
            let message = text(&output.stderr);
            assert_eq!(output.status.code(), Some(want), "{format}: {message}");
            assert!(message.contains("interrupted") && message.contains(says), "{message}");
        }
    }
}

/// A row that takes longer than the patience with a signal: the table is abandoned, and nothing of it is left.
#[test]
fn an_abandoned_table_leaves_nothing() {
    let desk = Sandbox::with(format!(
        "{STEEL}[solver]\nmethod = \"verlet\"\nsteps_per_contact = 1000000\n[sweep]\n\"impact.speed\" = {{ logspace = [0.1, 1], points = 4000 }}\n"
    ));
    let mut command = run(&desk, "out/deep", Some(250), &["--threads", "1"]);
    let child = command.env("PLM_IMPACT_TEST_PATIENCE_MS", "0").spawn().unwrap();
    let is_begun = |name: &String| name.starts_with(".table");
    let is_at_work = || desk.path("out/deep").exists() && desk.files("out/deep").iter().any(is_begun);
    let output = output_after_signal(child, is_at_work, "-INT");
    assert_eq!(output.status.code(), Some(130), "{}", text(&output.stderr));
    assert!(!desk.path("out").exists(), "{:?}", desk.files("out/deep"));
}

#[test]
fn parts_of_no_rows_are_no_parts() {
    let desk = Sandbox::with(random().replace("12000", "8"));
    ends(run(&desk, "out", Some(0), &[]), 0);
    assert_eq!(desk.files("out"), ["summary.json", "table.csv"]);
}
