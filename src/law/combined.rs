//! The loading of one law with the unloading of another.

use super::catalogue::LawChoice;
use super::contact_law::{About, Bodies, ContactLaw};
use super::published::{Loading, RecoveryRule};

/// Two halves.
///
/// What the unloading needs of the peak (force, indentation, contact radius) is what the loading gives.
#[derive(Debug, Clone, PartialEq)]
pub struct Combined {
    /// How it loads.
    pub loading: Box<LawChoice>,
    /// How it unloads.
    pub unloading: Box<LawChoice>,
}

static ABOUT: About = About {
    name: "combined",
    title: "Loading of one law, unloading of another",
    source: "those of its halves",
    loading: "named by `loading`",
    unloading: "named by `unloading`",
    validity: "those of its halves",
    confidence: "the lower of its halves",
};

impl ContactLaw for Combined {
    fn about(&self) -> &'static About {
        &ABOUT
    }

    fn loading(&self, bodies: &Bodies) -> Option<Loading> {
        self.loading.get().loading(bodies)
    }

    fn recovery(&self, bodies: &Bodies) -> Option<RecoveryRule> {
        self.unloading.get().recovery(bodies)
    }
}
