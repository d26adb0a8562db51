//! The loading curve of a law, with a part for deep dents that is computed when it is first needed.

use std::ops::Deref;
use std::sync::Arc;

use super::unloading_rule::PlmUnloadingRule;
use crate::numerics::curve::LoadingCurve;

/// A loading curve. As a [`LoadingCurve`] it is whole.
#[derive(Debug, Clone)]
pub struct DeferredCurve {
    /// The curve of shallow dents, which contacts share.
    shallow: Arc<LoadingCurve>,
    /// The rule of the same contact, if it has a correction for deep dents.
    deep: Option<Arc<PlmUnloadingRule>>,
}

impl From<Arc<LoadingCurve>> for DeferredCurve {
    fn from(curve: Arc<LoadingCurve>) -> Self {
        Self { shallow: curve, deep: None }
    }
}

impl Deref for DeferredCurve {
    type Target = LoadingCurve;

    #[inline]
    fn deref(&self) -> &LoadingCurve {
        self.deep.as_ref().and_then(|rule| rule.deep_curve()).unwrap_or(&self.shallow)
    }
}

impl DeferredCurve {
    /// The curve of shallow dents, which this rule corrects for deep ones.
    pub(in crate::contact) fn new(shallow: Arc<LoadingCurve>, rule: &Arc<PlmUnloadingRule>) -> Self {
        Self { shallow, deep: rule.depth.is_some().then(|| Arc::clone(rule)) }
    }

    pub(in crate::contact) fn shallow(&self) -> &Arc<LoadingCurve> {
        &self.shallow
    }

    /// The whole curve, or at least its part that a sphere of this kinetic energy and weight reaches.
    #[inline(always)]
    pub fn reached_by(&self, kinetic: f64, weight: f64) -> &LoadingCurve {
        match self.deep.as_ref().and_then(|rule| rule.depth.as_ref()) {
            Some(depth) if !depth.is_out_of_reach(kinetic, weight) => self,
            _ => &self.shallow,
        }
    }

    /// True if f at x is that of shallow dents.
    #[inline(always)]
    pub(in crate::contact) fn is_shallow(&self, x: f64) -> bool {
        self.deep.as_ref().is_none_or(|rule| rule.depth_at(x).is_none())
    }

    /// f at x.
    pub fn force(&self, x: f64) -> f64 {
        if self.is_shallow(x) { self.shallow.force(x) } else { (**self).force(x) }
    }

    /// f at x, without the rest of the curve. The last digit may differ from the last digit of [`DeferredCurve::force`].
    pub(super) fn force_at_one_point(&self, x: f64) -> f64 {
        let deep = self.deep.as_ref().and_then(|rule| rule.deep_force(rule.depth_at(x)?, x));
        deep.unwrap_or_else(|| self.force(x))
    }

    /// Work from first contact to x.
    pub fn work(&self, x: f64) -> f64 {
        if self.is_shallow(x) { self.shallow.work(x) } else { (**self).work(x) }
    }
}
