//! A headless Chromium that opens pages, runs a probe in them and takes pictures of them.

use serde_json::Value;
use std::path::{Path, PathBuf};
use std::process::{Command, Stdio};
use std::time::{Duration, Instant};

/// Set to 1 where a missing browser must fail the tests; otherwise they are reported as ignored.
pub const REQUIRE_BROWSER: &str = "INTERREFLECT_REQUIRE_BROWSER";

const PROGRAMS: [&str; 4] = ["chromium", "chromium-browser", "google-chrome", "google-chrome-stable"];
/// What the probe's answer stands between.
const MARKS: [&str; 2] = ["@@probe ", " probe@@"];
/// How long a page may take.
const LIMIT: Duration = Duration::from_secs(90);

/// Path of the browser.
pub fn find() -> Option<PathBuf> {
    let path = std::env::var_os("PATH")?;
    let folders: Vec<PathBuf> = std::env::split_paths(&path).collect();
    PROGRAMS.iter().find_map(|name| folders.iter().map(|f| f.join(name)).find(|p| p.is_file()))
}

/// Whether [`REQUIRE_BROWSER`] is set.
pub fn required() -> bool {
    std::env::var_os(REQUIRE_BROWSER).is_some_and(|value| value != "0" && !value.is_empty())
}

/// Opens a page in a window of this width and gives what the probe saw: `{errors, pictures, broken, tables, unsorted,
/// overflow_px, text_px, title, words}`. A picture of the window goes to `screenshot`.
///
/// # Errors
/// No browser, a browser that does not answer, a page that cannot be read: in words.
pub fn probe(page: &Path, width_px: u32, height_px: u32, screenshot: Option<&Path>) -> Result<Value, String> {
    let browser = find().ok_or("no Chromium on the path")?;
    let folder = tempfile::tempdir().map_err(|e| e.to_string())?;
    let html = std::fs::read_to_string(page).map_err(|e| format!("{}: {e}", page.display()))?;
    // The probe goes into a copy: in front to hear every error, at the end to look. A frame has a window of any width,
    // the browser's own is at least 500 pixels wide.
    let html = html
        .replacen("<head>", &format!("<head><script>{}</script>", include_str!("browser_errors.js")), 1)
        .replacen("</body>", &format!("<script>{}</script></body>", include_str!("browser_probe.js")), 1);
    let write = |name: &str, text: &str| {
        let path = folder.path().join(name);
        std::fs::write(&path, text).map(|()| path).map_err(|e| e.to_string())
    };
    write("page.html", &html)?;
    let frame = write(
        "frame.html",
        &format!(
            "<!doctype html><body style=\"margin:0\"><iframe src=\"page.html\" style=\"border:0;display:block\" \
             width=\"{width_px}\" height=\"{height_px}\"></iframe><pre id=\"answer\" hidden></pre><script>\
             addEventListener('message',(e)=>{{document.getElementById('answer').textContent='{}'+e.data+'{}'}})</script>",
            MARKS[0], MARKS[1]
        ),
    )?;
    let address = format!("file://{}", frame.display());
    if let Some(path) = screenshot {
        let size = format!("--window-size={},{height_px}", width_px.max(500));
        run(&browser, folder.path(), &[&size, &format!("--screenshot={}", path.display()), &address])?;
    }
    let dom = run(&browser, folder.path(), &["--dump-dom", &address])?;
    let answer = dom
        .split_once(MARKS[0])
        .and_then(|(_, rest)| rest.split_once(MARKS[1]))
        .map(|(json, _)| json.replace("&lt;", "<").replace("&gt;", ">").replace("&amp;", "&"))
        .filter(|json| json.starts_with('{'))
        .ok_or_else(|| format!("the page did not answer: {}", dom.chars().take(500).collect::<String>()))?;
    serde_json::from_str(&answer).map_err(|e| format!("{e}: {answer}"))
}

fn run(browser: &Path, folder: &Path, args: &[&str]) -> Result<String, String> {
    let out = folder.join("stdout.txt");
    let file = std::fs::File::create(&out).map_err(|e| e.to_string())?;
    let mut child = Command::new(browser)
        .args(["--headless=new", "--no-sandbox", "--disable-gpu", "--hide-scrollbars", "--no-first-run"])
        .args(["--allow-file-access-from-files", "--virtual-time-budget=20000", "--disable-dev-shm-usage"])
        .arg(format!("--user-data-dir={}", folder.join("profile").display()))
        .args(args)
        .stdin(Stdio::null())
        .stdout(file)
        .stderr(Stdio::null())
        .spawn()
        .map_err(|e| format!("{}: {e}", browser.display()))?;
    let start = Instant::now();
    let status = loop {
        match child.try_wait().map_err(|e| e.to_string())? {
            Some(status) => break status,
            None if start.elapsed() > LIMIT => {
                let _ = child.kill();
                let _ = child.wait();
                return Err(format!("the browser took more than {} s", LIMIT.as_secs()));
            }
            None => std::thread::sleep(Duration::from_millis(20)),
        }
    };
    if !status.success() {
        return Err(format!("the browser: {status}"));
    }
    std::fs::read(&out).map(|b| String::from_utf8_lossy(&b).into_owned()).map_err(|e| e.to_string())
}
