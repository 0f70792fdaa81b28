//! `lemnis build`: both FMUs, with the book inside, and the book.

use clap::Args;

use crate::commands::book::Making;
use crate::commands::fmu::{Pack, documentation, fmus};
use crate::decision::to_build;
use crate::failure::Failure;
use crate::output::{say, write};

#[derive(Args)]
pub struct Build {
    #[command(flatten)]
    pack: Pack,
    #[command(flatten)]
    making: Making,
}

impl Build {
    pub fn run(&self) -> Result<(), Failure> {
        let Pack { make, platforms } = &self.pack;
        let scene = to_build(make.scene.as_deref())?.announced()?;
        let (results, pdf) = self.making.pdf(&scene)?;
        let documentation = documentation(&scene, Some(&pdf))?;
        let mut outputs = fmus(&scene, platforms.as_deref(), &documentation)?;
        outputs.push(pdf);
        say(format_args!("{}\n{}", scene.title(), results.summary()))?;
        write(&make.output, &outputs)
    }
}
