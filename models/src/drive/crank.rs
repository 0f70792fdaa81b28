//! A crank on the frame whose rod turns the driving link: a four-bar of the link's arm, rod, crank and frame.

use crate::component::stages::{Found, results};
use crate::drive::mount::{Anchors, DriveMount, DrivenBar};
use crate::drive::symbols as s;
use crate::kernel::calc::Calc;
use crate::kernel::group::{One, quantities};
use crate::kernel::variable::Fault;
use crate::parts::closure::Closure;
use crate::parts::four_bar::{Branch, FourBar, Names};
use crate::parts::motion::degrees;
use crate::parts::plane::{Point, cross, dot};

quantities! {
    /// Radius of the crank and length of its rod, in m.
    CrankRod { r_cr: R_CR, l_cr: L_CR }
}

/// Crank and rod at one position.
#[derive(Clone, Copy, Debug)]
pub struct Cranked<C> {
    /// The link's arm from its foot, the crank from its centre, and the rod from the crank to the arm, in m.
    pub arm: Point<C>,
    pub crank: Point<C>,
    pub line: Point<C>,
    /// Lever arm of a push of the rod about the crank's centre, in m.
    pub h_cr: C,
    theta_cr: C,
    alpha_cr: C,
    beta_cr: C,
}
results! { Cranked as c => { THETA_CR: c.theta_cr; H_CR: c.h_cr; ALPHA_CR: c.alpha_cr; BETA_CR: c.beta_cr; } }

impl<C: Calc> CrankRod<C> {
    /// The four-bar of an arm of this length (m), with the crank's centre from the link's foot (m), and the crank's pin on
    /// this side of the line from the centre to the arm's end; `None` where it closes at no angle.
    pub fn linkage(&self, arm: C, centre: Point<C>, branch: Branch) -> Option<FourBar<C>> {
        FourBar::new([arm, self.l_cr, self.r_cr], centre, branch, &NAMES)
    }

    /// The direction of the arm given, in rad: r sin(α + β) is the rod's lever arm about the crank's centre, where crank
    /// and rod lie at α and β to the circle on which the arm's end moves; `None` where the linkage does not close.
    /// [Ports001, 5.3]
    pub fn at(&self, linkage: &FourBar<C>, phi_d: C) -> Option<Cranked<C>> {
        let Closure {
            crank: arm,
            coupler,
            follower: crank,
            area,
            ..
        } = Closure::new(linkage, phi_d, &NAMES)?;
        let line = -coupler;
        Some(Cranked {
            arm,
            crank,
            line,
            // The area keeps its digits up to the dead points, where crank and rod lie in one line.
            h_cr: (-(area / (C::constant(2.0) * self.l_cr))).def(&s::H_CR),
            theta_cr: C::direction(crank.x, crank.y).def(&s::THETA_CR),
            alpha_cr: C::direction(cross(arm, crank), dot(arm, crank)).def(&s::ALPHA_CR),
            beta_cr: C::direction(cross(arm, line), -dot(arm, line)).def(&s::BETA_CR),
        })
    }
}

impl<C: Calc> Cranked<C> {
    /// T = F r sin(α + β) / cos β for the force F (N) across the link's arm, given as F / cos β. [Ports001, 5.3]
    pub fn by_slider(&self, rod: &CrankRod<C>, push: C) -> C {
        (push * rod.r_cr * (self.alpha_cr + self.beta_cr).sin()).def(&s::T_CR)
    }

    /// Angle of the crank, in rad.
    pub fn angle(&self) -> C {
        self.theta_cr
    }

    /// cos β.
    pub fn across(&self) -> C {
        self.beta_cr.sin_cos().1
    }
}

/// The four-bar of a crank on this side, the driving link turning about `foot`, in m, or about the origin; `None` where it
/// closes at no angle.
pub fn crank_linkage<C: Calc>(
    rod: &CrankRod<C>,
    a: &Anchors<C>,
    foot: Option<Point<C>>,
    branch: Branch,
) -> Option<FourBar<C>> {
    let centre = Point::new(a.e_x, a.e_y);
    rod.linkage(a.s_d, foot.map_or(centre, |foot| centre - foot), branch)
}

/// The same of a drive that has one.
///
/// # Errors
/// A rod that reaches the driving link at no angle.
pub fn crank<C: Calc>(
    rod: &CrankRod<C>,
    mount: &DriveMount<C>,
    foot: Option<Point<C>>,
    branch: Branch,
) -> Found<FourBar<C>> {
    let linkage = crank_linkage(rod, mount.anchors()?, foot, branch);
    linkage.ok_or_else(|| Box::new(Fault::outside("the crank's rod meets the driving link at no angle")))
}

/// Crank and rod at a position.
///
/// # Errors
/// An angle at which they do not meet.
pub fn cranked<C: Calc>(
    linkage: &FourBar<C>,
    rod: &CrankRod<C>,
    mount: &DriveMount<C>,
    bar: &DrivenBar<C>,
) -> Found<Cranked<C>> {
    let (a, One(symbol, angle)) = (mount.anchors()?, bar.angle);
    let phi_d = (angle + a.chi_d).def(&s::PHI_D);
    rod.at(linkage, phi_d).ok_or_else(|| {
        let at = format!("{} = {}", symbol.id, degrees(angle.value()));
        let closes = arcs(linkage, a.chi_d.value());
        Box::new(Fault::outside(format!(
            "{at}: crank and rod do not meet there; they do for {closes}"
        )))
    })
}

/// Angles of the driving link at which crank and rod meet, in words.
pub fn arcs<C: Calc>(linkage: &FourBar<C>, chi_d: f64) -> String {
    let arcs = linkage.arcs().into_iter();
    let words: Vec<String> = arcs
        .map(|arc| format!("{} to {}", degrees(arc.from - chi_d), degrees(arc.to - chi_d)))
        .collect();
    words.join(" and for ")
}

static NAMES: Names = Names {
    frame: &s::D_CR,
    frame_angle: &s::DELTA_CR,
    stretched: [&s::PHI_CRS, &s::PHI_CRS2],
    folded: [&s::PHI_CRF, &s::PHI_CRF2],
    crank: [&s::R_DX, &s::R_DY],
    diagonal: [&s::A_CRX, &s::A_CRY],
    diagonal_length: &s::A_CR,
    stretched_margin: &s::SIGMA_CRS,
    folded_margin: &s::SIGMA_CRF,
    area: &s::K_CR,
    follower: [&s::R_CRX, &s::R_CRY],
    coupler: [&s::L_CRX, &s::L_CRY],
};
