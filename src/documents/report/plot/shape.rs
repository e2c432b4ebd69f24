//! Shapes on a page; lengths in points, `y` downwards.

/// A colour.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Colour(pub u8, pub u8, pub u8);

impl Colour {
    /// The grey that is as bright.
    #[must_use]
    pub fn grey(self) -> Colour {
        let Colour(r, g, b) = self;
        // Weights of the three colours in the brightness of a screen (ITU-R BT.601), in thousandths.
        let grey = (299 * u32::from(r) + 587 * u32::from(g) + 114 * u32::from(b)) / 1000;
        let grey = u8::try_from(grey).unwrap_or(u8::MAX);
        Colour(grey, grey, grey)
    }
}

/// Ink.
pub(crate) const BLACK: Colour = Colour(0, 0, 0);
/// Fine lines behind the curves.
pub(crate) const PALE: Colour = Colour(0xdd, 0xdd, 0xdd);
/// Paper.
pub(crate) const WHITE: Colour = Colour(0xff, 0xff, 0xff);

/// The palette of Okabe and Ito without its yellow, which is too pale for lines on paper.
pub(crate) const PALETTE: [Colour; 7] = [
    Colour(0x00, 0x72, 0xb2),
    Colour(0xd5, 0x5e, 0x00),
    Colour(0x00, 0x9e, 0x73),
    Colour(0xcc, 0x79, 0xa7),
    Colour(0x00, 0x00, 0x00),
    Colour(0xe6, 0x9f, 0x00),
    Colour(0x56, 0xb4, 0xe9),
];

/// Dashes that go with the colours; empty for a full line.
pub(crate) const DASHES: [&[f32]; 7] =
    [&[], &[7.0, 3.0], &[2.0, 2.5], &[9.0, 3.0, 2.0, 3.0], &[4.0, 2.0], &[12.0, 4.0], &[1.0, 3.0]];

/// Where a text stands relative to its point.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Anchor {
    /// It begins there.
    Start,
    /// It is centred there.
    Middle,
    /// It ends there.
    End,
}

/// Something that is drawn.
#[derive(Clone, Debug)]
pub enum Shape {
    /// An open line through points.
    Line {
        /// The points.
        points: Vec<(f32, f32)>,
        /// The colour.
        colour: Colour,
        /// The width.
        width: f32,
        /// Lengths of dashes and gaps; empty for a full line.
        dash: &'static [f32],
    },
    /// A filled area.
    Area {
        /// Its corners.
        points: Vec<(f32, f32)>,
        /// The colour.
        colour: Colour,
    },
    /// A disc, or a ring.
    Dot {
        /// The centre.
        at: (f32, f32),
        /// The radius.
        radius: f32,
        /// The colour.
        colour: Colour,
        /// A disc if so, else a ring filled with white.
        full: bool,
    },
    /// A text; `_{…}` and `^{…}` lower and raise.
    Text {
        /// The point on the line on which the letters stand.
        at: (f32, f32),
        /// The text.
        text: String,
        /// The height of the letters' square.
        size: f32,
        /// Where it stands.
        anchor: Anchor,
        /// Whether it is written upwards.
        upwards: bool,
    },
}

/// A page of shapes, the later ones above.
#[derive(Clone, Debug)]
pub struct Page {
    /// Its width.
    pub width: f32,
    /// Its height.
    pub height: f32,
    /// What it shows, in a few words.
    pub title: String,
    /// Its scales and its legend in words, for readers who cannot see it.
    pub description: String,
    /// The shapes.
    pub shapes: Vec<Shape>,
}

impl Page {
    /// The page without colours. Curves are told apart by their dashes, areas by their brightness.
    #[must_use]
    pub fn grey(mut self) -> Page {
        for shape in &mut self.shapes {
            match shape {
                // A pale curve would be lost, and a dot on it looks like the curve.
                Shape::Line { colour, width, .. } if *width > 1.6 && *colour != WHITE => *colour = BLACK,
                Shape::Dot { colour, .. } if *colour != WHITE => *colour = BLACK,
                Shape::Line { colour, .. } | Shape::Area { colour, .. } | Shape::Dot { colour, .. } => {
                    *colour = colour.grey();
                }
                Shape::Text { .. } => {}
            }
        }
        self
    }
}
