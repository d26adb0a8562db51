//! Pictures are decoded, and the colours at known places are checked.

use plm_impact::impact::{Contact, Impact, Solver};
use plm_impact::law::Plm;
use plm_impact::material::{HalfSpace, Material, Sphere};
use plm_impact::plot::{self, Axis, Guide, Heatmap, Histogram, Lines, PlotError, Series};

type Rgb = [u8; 3];
/// The first colours of Okabe and Ito (2008), in the order of the series.
const BLUE: Rgb = [0x00, 0x72, 0xb2];
const VERMILLION: Rgb = [0xd5, 0x5e, 0x00];
const GREEN: Rgb = [0x00, 0x9e, 0x73];
const PURPLE: Rgb = [0xcc, 0x79, 0xa7];
const ORANGE: Rgb = [0xe6, 0x9f, 0x00];
const SKY: Rgb = [0x56, 0xb4, 0xe9];
const INK: Rgb = [0x22, 0x22, 0x22];
const WHITE: Rgb = [0xff, 0xff, 0xff];

struct Picture {
    width: usize,
    pixels: Vec<Rgb>,
}

impl Picture {
    fn decoded(bytes: &[u8]) -> Self {
        let mut reader = png::Decoder::new(std::io::Cursor::new(bytes)).read_info().unwrap();
        let mut buffer = vec![0; reader.output_buffer_size().unwrap()];
        let info = reader.next_frame(&mut buffer).unwrap();
        assert_eq!((info.width, info.height), plot::SIZE);
        assert_eq!(info.color_type, png::ColorType::Rgb);
        let pixels: Vec<Rgb> = buffer.chunks_exact(3).map(|rgb| [rgb[0], rgb[1], rgb[2]]).collect();
        let picture = Self { width: info.width as usize, pixels };
        let inked = picture.pixels.iter().filter(|pixel| **pixel != WHITE).count();
        assert!(inked > picture.pixels.len() / 100, "an empty picture: {inked} pixels");
        picture
    }

    fn at(&self, x: f64, y: f64) -> Rgb {
        #[allow(clippy::cast_possible_truncation, clippy::cast_sign_loss)]
        let (x, y) = (x.round() as usize, y.round() as usize);
        self.pixels[y * self.width + x]
    }

    /// All pixels with a colour.
    fn places(&self, color: Rgb) -> Vec<(usize, usize)> {
        let index = |i: usize| (i % self.width, i / self.width);
        self.pixels.iter().enumerate().filter(|(_, pixel)| **pixel == color).map(|(i, _)| index(i)).collect()
    }

    /// The box with the axes: left, top, right, bottom. Its outline is the only long black line.
    fn axes(&self) -> [f64; 4] {
        let mut columns = vec![0; self.width];
        let mut rows = vec![0; self.pixels.len() / self.width];
        for (x, y) in self.places(INK) {
            columns[x] += 1;
            rows[y] += 1;
        }
        #[allow(clippy::cast_precision_loss)]
        let ends = |counts: &[usize]| {
            let long = |count: &usize| *count > 600;
            let (first, last) = (counts.iter().position(long).unwrap(), counts.iter().rposition(long).unwrap());
            (first as f64, last as f64)
        };
        let ((left, right), (top, bottom)) = (ends(&columns), ends(&rows));
        [left, top, right, bottom]
    }

    /// Whether a colour is found within three pixels of a place given in shares of the axes.
    fn shows(&self, color: Rgb, (x, y): (f64, f64)) -> bool {
        let [left, top, right, bottom] = self.axes();
        let (x, y) = (left + x * (right - left), bottom - y * (bottom - top));
        (-3..=3).any(|dx| (-3..=3).any(|dy| self.at(x + f64::from(dx), y + f64::from(dy)) == color))
    }
}

fn impact(sphere_modulus: f64, yield_strength: Option<f64>, speed: f64) -> Impact {
    let material = |youngs_modulus| Material { youngs_modulus, poissons_ratio: 0.3 };
    let sphere = Sphere { radius: 5e-3, material: material(sphere_modulus), density: 7850.0, yield_strength: None };
    let half_space = HalfSpace { material: material(210e9), yield_strength, density: None };
    let contact = Contact::try_new(sphere, half_space, &Plm::default()).unwrap();
    contact.impact(speed, &Solver::default(), Some(400)).unwrap()
}

fn scenes() -> [Impact; 4] {
    [
        impact(210e9, Some(345e6), 3.0),
        impact(210e9, None, 3.0),
        impact(f64::INFINITY, Some(345e6), 3.0),
        impact(210e9, Some(345e6), 0.012),
    ]
}

fn extent(places: &[(usize, usize)]) -> (usize, usize) {
    let span = |of: fn(&(usize, usize)) -> usize| {
        places.iter().map(of).max().unwrap_or(0) - places.iter().map(of).min().unwrap_or(0)
    };
    (span(|place| place.0), span(|place| place.1))
}

#[test]
fn force_against_indentation_shows_three_loops_that_fill_the_axes() {
    for impact in scenes() {
        let picture = Picture::decoded(&plot::force_indentation(&impact).unwrap().to_png().unwrap());
        let [left, top, right, bottom] = picture.axes();
        #[allow(clippy::cast_precision_loss)]
        let inside = |color| {
            let mut places = picture.places(color);
            places.retain(|(x, y)| (*x as f64) < right && (*y as f64) > top);
            places
        };
        for color in [BLUE, VERMILLION, GREEN] {
            assert!(inside(color).len() > 300, "{color:?}: {}", inside(color).len());
        }
        #[allow(clippy::cast_precision_loss)]
        let (wide, high) = { (extent(&inside(BLUE)).0 as f64, extent(&inside(BLUE)).1 as f64) };
        assert!(wide > 0.9 * (right - left) && high > 0.85 * (bottom - top), "{wide} x {high}");
        // the black marker of the peak is at 1/1.06 and 1/1.08 of the box, from the ranges of the axes
        assert!(picture.shows(INK, (1.0 / 1.06, 1.0 / 1.08)));
        if impact.has_dent() {
            let residual = impact.residual_indentation / (1.06 * impact.peak_indentation);
            assert!(picture.shows(INK, (residual, 0.005)));
        }
    }
}

#[test]
fn history_shows_force_indentations_and_speed() {
    for impact in scenes() {
        let picture = Picture::decoded(&plot::history(&impact).unwrap().to_png().unwrap());
        for color in [PURPLE, BLUE, VERMILLION, GREEN, ORANGE] {
            assert!(picture.places(color).len() > 300, "{color:?}");
        }
        // three boxes one below the other: force at the top, speed at the bottom
        let highest = |color| picture.places(color).iter().map(|place| place.1).min().unwrap();
        assert!(highest(PURPLE) < 360 && highest(BLUE) < 620 && highest(ORANGE) < 900);
    }
}

#[test]
fn the_same_data_give_the_same_bytes() {
    let impact = impact(210e9, Some(345e6), 3.0);
    for draw in [plot::force_indentation, plot::history] {
        let [one, other] = [(); 2].map(|()| draw(&impact).unwrap());
        assert_eq!(one.to_png().unwrap(), other.to_png().unwrap());
        assert_eq!(one.to_svg().unwrap(), other.to_svg().unwrap());
    }
}

#[test]
fn an_impact_without_trace_makes_no_picture() {
    let mut impact = impact(210e9, None, 3.0);
    impact.trace.clear();
    assert!(matches!(plot::force_indentation(&impact), Err(PlotError::Data(_))));
    assert!(matches!(plot::history(&impact), Err(PlotError::Data(_))));
}

fn lines(x: Axis, y: Axis, curves: Vec<Vec<(f64, f64)>>) -> Lines {
    let series = curves.into_iter().zip(["first", "second", "third"]);
    let series = series.map(|(points, name)| Series::marked_line(name, points));
    Lines { title: "Title".into(), x, y, series: series.collect(), guides: vec![], notes: vec!["note".into()] }
}

#[test]
fn a_curve_lies_where_its_values_are() {
    let linear = || Axis::linear("x", "m").between(0.0, 2.0);
    let log = || Axis::log("x", "m").between(1.0, 1e4);
    let cases = [
        lines(linear(), linear(), vec![vec![(0.0, 0.0), (2.0, 2.0)]]),
        lines(log(), log(), vec![vec![(1.0, 1.0), (1e4, 1e4)]]),
    ];
    for case in cases {
        let picture = Picture::decoded(&case.draw().unwrap().to_png().unwrap());
        for share in [0.1, 0.35, 0.6, 0.9] {
            assert!(picture.shows(BLUE, (share, share)), "{share}");
            assert!(!picture.shows(BLUE, (share, 1.0 - share + 0.3 * share)), "{share}");
        }
    }
}

#[test]
fn curves_and_guides_are_cut_at_the_axes() {
    let mut plot = lines(
        Axis::linear("x", "").between(0.0, 1.0),
        Axis::linear("y", "").between(0.0, 1.0),
        vec![vec![(-1.0, 0.25), (2.0, 0.25)], vec![(0.5, -5.0), (0.5, 5.0)], vec![(-3.0, 9.0), (9.0, 9.0)]],
    );
    plot.guides =
        vec![Guide::vertical(7.0, "outside"), Guide::horizontal(0.75, "level"), Guide::power((0.5, 0.5), 1.0, "slope")];
    let picture = Picture::decoded(&plot.draw().unwrap().to_png().unwrap());
    let [left, top, right, bottom] = picture.axes();
    assert!(picture.shows(BLUE, (0.01, 0.25)) && picture.shows(BLUE, (0.99, 0.25)));
    assert!(picture.shows(VERMILLION, (0.5, 0.97)));
    #[allow(clippy::cast_precision_loss)]
    for (x, y) in picture.places(BLUE).into_iter().chain(picture.places(VERMILLION)) {
        let (x, y) = (x as f64, y as f64);
        // points to the right of the axes belong to the key
        assert!(x > right || (x >= left - 4.0 && y >= top - 4.0 && y <= bottom + 4.0), "{x} {y}");
    }
}

#[test]
fn odd_data_make_a_picture_and_no_panic() {
    let odd: Vec<Vec<(f64, f64)>> = vec![
        vec![],
        vec![(1.0, 1.0)],
        vec![(0.0, 0.0), (f64::NAN, 1.0), (f64::INFINITY, -1.0), (-3.0, 1e300)],
        vec![(1.0, 1.0), (2.0, 1.0 + 1e-16)],
        vec![(5e-324, 1e-310), (1e-300, 1e308)],
    ];
    for points in odd {
        for axis in [Axis::linear("x", "m"), Axis::engineering("x", "m"), Axis::log("x", "m")] {
            let png = lines(axis.clone(), axis.clone(), vec![points.clone()]).draw().unwrap().to_png().unwrap();
            Picture::decoded(&png);
        }
    }
}

#[test]
fn a_heat_map_has_each_cell_in_its_colour() {
    let mut map = Heatmap {
        title: "e".into(),
        x: Axis::log("Speed", "m/s"),
        y: Axis::engineering("Strength", "Pa"),
        x_values: vec![1.0, 10.0],
        y_values: vec![1e8, 2e8],
        values: vec![0.0, 1.0, f64::NAN, 0.5],
        color: Axis::linear("e", "").between(0.0, 1.0),
    };
    let picture = Picture::decoded(&map.draw().unwrap().to_png().unwrap());
    // both ends of viridis (van der Walt and Smith 2015): 440154 and fde725; places as shares of the axes
    let [left, top, right, bottom] = picture.axes();
    let cells = [((0.2, 0.25), [0x44, 0x01, 0x54]), ((0.65, 0.25), [0xfd, 0xe7, 0x25]), ((0.2, 0.9), [0xe2; 3])];
    for ((x, y), color) in cells {
        let place = (left + x * (right - left), bottom - y * (bottom - top));
        let got = picture.at(place.0, place.1);
        assert!(got.iter().zip(color).all(|(a, b)| a.abs_diff(b) <= 2), "{got:?} for {color:?}");
    }
    map.values.pop();
    assert!(matches!(map.draw(), Err(PlotError::Data(_))));
}

#[test]
fn bars_are_as_high_as_their_counts() {
    let mut histogram = Histogram {
        title: "e".into(),
        x: Axis::linear("e", ""),
        edges: vec![0.0, 1.0, 2.0, 3.0, 4.0],
        counts: vec![100, 50, 0, 25],
        lines: vec![(0.5, "mean 0.5".into())],
        notes: vec!["sd 0.1".into()],
    };
    let picture = Picture::decoded(&histogram.draw().unwrap().to_png().unwrap());
    for (bin, count) in [(0.0, 100.0), (1.0, 50.0), (3.0, 25.0)] {
        // the axis ends 6 % above the highest bar
        let (x, height) = ((bin + 0.3) / 4.0, count / 106.0);
        assert!(picture.shows(SKY, (x, height - 0.02)) && !picture.shows(SKY, (x, height + 0.02)), "{bin}");
    }
    assert!(!picture.shows(SKY, (2.5 / 4.0, 0.05)));
    histogram.edges.pop();
    assert!(matches!(histogram.draw(), Err(PlotError::Data(_))));
}
