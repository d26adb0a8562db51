#!/usr/bin/env bash
# Makes the page: a folder of static files for any web server. bash src/doors/web/build.sh [FOLDER] [PROFILE]
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
bindgen=$build/tools/bin/wasm-bindgen
[ "$("$bindgen" --version 2>/dev/null)" = "wasm-bindgen $version" ] || CARGO_PROFILE_DEV_OPT_LEVEL=0 cargo install --quiet --debug --force \
    wasm-bindgen-cli --version "$version" --no-default-features --bin wasm-bindgen --root "$build/tools" --target-dir "$build/tools"
cargo rustc --quiet --lib --crate-type cdylib --no-default-features --features web --target $target --profile "$profile"
mkdir -p "$out"
"$bindgen" --target web --no-typescript --remove-name-section --remove-producers-section --out-dir "$out" \
    "$build/$target/${profile/#dev/debug}/plm_impact.wasm"
cp src/doors/web/page/* src/doors/licenses.txt "$out"
# the documents, with the pictures and files that they show, and the source: a page without the network has them too
for document in README.md src/README.md scenarios/*.md plots/*/*.md; do
    from=$(dirname "$document")
    html=$out/pages/${document%.md}.html
    mkdir -p "$out/pages/$from"
    rustdoc --markdown-no-toc --markdown-css "../$(tr -cd / <<<"$document" | sed 's|/|../|g')page.css" --output "$out/pages/$from" "$document"
    for file in $(grep -oE '(href|src)="[^":#]+' "$html" | sed -nE '/\.(md|css)$/!s/.*"//p' | sort -u); do
        # the package of the crate has not all pictures
        [ ! -e "$from/$file" ] || install -D -m 644 "$from/$file" "$out/pages/$from/$file"
    done
    sed -i -E 's/(href="[^":]*)\.md/\1.html/g' "$html"
done
cargo package --quiet --no-verify --allow-dirty
cp "$build"/package/plm-impact-*.crate "$out/pages/source.tar.gz"
