#!/usr/bin/env bash
# Makes the page: a folder of static files for any web server. bash src/interfaces/web/build.sh [FOLDER] [PROFILE]
# Needs Rust and a network the first time: the target, and wasm-bindgen in the version of Cargo.lock, which stays in the build folder.
set -euo pipefail
cd "$(dirname "$0")/../../.."
out=${1:-target/page}
profile=${2:-web}
target=wasm32-unknown-unknown
# where cargo builds: target, or what a variable or a configuration file says
build=$(cargo metadata --format-version 1 --no-deps | sed 's/.*"target_directory":"\([^"]*\)".*/\1/')
rustup target list --installed | grep -qx $target || rustup target add $target
version=$(grep -A1 '^name = "wasm-bindgen"$' Cargo.lock | sed -n 's/^version = "\(.*\)"$/\1/p')
# its library with a front end of a few lines: a third of the crates of wasm-bindgen-cli, whose tools for tests need a web server
tool=$build/tools/bindgen-$version
if [ ! -x "$tool/debug/bindgen" ]; then
    mkdir -p "$tool/src"
    cat >"$tool/Cargo.toml" <<END
[package]
name = "bindgen"
edition = "2024"
[dependencies]
wasm-bindgen-cli-support = "=$version"
[workspace]
END
    cat >"$tool/src/main.rs" <<END
fn main() -> Result<(), Box<dyn std::error::Error>> {
    let files: Vec<String> = std::env::args().collect();
    let mut bindgen = wasm_bindgen_cli_support::Bindgen::new();
    bindgen.web(true)?.typescript(false).remove_name_section(true).remove_producers_section(true);
    Ok(bindgen.input_path(&files[1]).generate(&files[2])?)
}
END
    # the crates of the tool in the versions that were tried: renew this file when Cargo.lock gets another wasm-bindgen
    cp src/interfaces/web/bindgen.lock "$tool/Cargo.lock"
    CARGO_PROFILE_DEV_DEBUG=none cargo build --quiet --locked --manifest-path "$tool/Cargo.toml" --target-dir "$tool"
fi
cargo rustc --quiet --locked --lib --crate-type cdylib --no-default-features --features web --target $target --profile "$profile"
mkdir -p "$out"
"$tool/debug/bindgen" "$build/$target/${profile/#dev/debug}/plm_impact.wasm" "$out"
cp -r src/interfaces/web/page/* src/interfaces/licenses.txt "$out"
# the documents, with the pictures and files that they show, and the source: a page without the network has them too
for document in README.md CHANGELOG.md CONTRIBUTING.md src/README.md tests/README.md scenarios/*.md plots/*/*.md; do
    from=$(dirname "$document")
    html=$out/pages/${document%.md}.html
    mkdir -p "$out/pages/$from"
    rustdoc --markdown-no-toc --markdown-css "../$(tr -cd / <<<"$document" | sed 's|/|../|g')page.css" --output "$out/pages/$from" "$document"
    grep -oE '(href|src)="[^":#]+' "$html" | sed -nE '/\.(md|css)$/!s/.*"//p' | sort -u | while read -r file; do
        # the package of the crate has not all pictures
        [ ! -e "$from/$file" ] || install -D -m 644 "$from/$file" "$out/pages/$from/$file"
    done
    sed -i -E 's/(href="[^":]*)\.md/\1.html/g' "$html"
done
cargo package --quiet --locked --no-verify --allow-dirty
cp "$build"/package/plm-impact-*.crate "$out/pages/source.tar.gz"
