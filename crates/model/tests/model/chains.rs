//! The decomposition into chains.

use solaris_model::{Chains, Figure, FigureBuilder, Joint, LinkSpec, human};

/// Each link as "name parent dofs".
fn figure(links: &[(&str, &str, usize)]) -> Figure {
    let mut builder = FigureBuilder::new("arm");
    for (name, parent, dofs) in links {
        let mut joint = Joint::new(*name);
        for _ in 0..*dofs {
            joint = joint.rx();
        }
        let link = match *parent {
            "" => LinkSpec::root(*name, joint),
            parent => LinkSpec::child(*name, parent, joint),
        };
        builder = builder.link(link.mass(1.0));
    }
    builder.build().expect("valid")
}

/// Every link and dof of the figure is new in exactly one chain, and what is shared stands first.
fn check(figure: &Figure) -> Chains {
    let chains = Chains::of(figure);
    let (mut links, mut dofs) = (Vec::new(), Vec::new());
    for chain in &chains {
        assert!(chain.links[..chain.shared_links].iter().all(|link| links.contains(link)));
        assert!(chain.dofs[..chain.shared_dofs].iter().all(|dof| dofs.contains(dof)));
        links.extend(&chain.links[chain.shared_links..]);
        dofs.extend(&chain.dofs[chain.shared_dofs..]);
    }
    links.sort_unstable();
    dofs.sort_unstable();
    assert_eq!(links, (0..figure.links().len()).collect::<Vec<_>>());
    assert_eq!(dofs, (0..figure.layout().nv()).collect::<Vec<_>>());
    chains
}

#[test]
fn the_human_has_five_chains() {
    insta::assert_snapshot!(check(&human(1.75, 73.0).expect("within range")), @"
    human: 21 links, 66 dofs, 5 chains
                                       of these in an earlier chain
    chain  end-effector  links   dofs  links   dofs
        1  head              5     18      0      0    0 %
        2  left_hand         7     24      3     12   50 %
        3  left_toes         5     18      1      6   33 %
        4  right_hand        7     24      3     12   50 %
        5  right_toes        5     18      1      6   33 %
      sum                   29    102      8     36   35 %
    ");
}

#[test]
fn the_figure_of_section_4_2_has_two_chains() {
    // Links 1, 2, then 3, 4, 5 and 6, 7, 8.
    let chains = check(&figure(&[
        ("1", "", 1),
        ("2", "1", 1),
        ("3", "2", 1),
        ("4", "3", 1),
        ("5", "4", 1),
        ("6", "2", 1),
        ("7", "6", 1),
        ("8", "7", 1),
    ]));
    let found: Vec<_> = chains.iter().map(|chain| (chain.links.clone(), chain.shared_links)).collect();
    assert_eq!(found, [(vec![0, 1, 2, 3, 4], 0), (vec![0, 1, 5, 6, 7], 2)]);
}

#[test]
fn welded_links_are_part_of_the_body_that_carries_them() {
    let chains = check(&figure(&[
        ("base", "", 0),
        ("post", "base", 0),
        ("left", "post", 2),
        ("tool", "left", 0),
        ("sensor", "left", 0),
        ("right", "base", 1),
        ("bracket", "right", 0),
        ("finger", "bracket", 1),
    ]));
    insta::assert_snapshot!(chains, @"
    arm: 8 links, 4 dofs, 2 chains
                                       of these in an earlier chain
    chain  end-effector  links   dofs  links   dofs
        1  left              5      2      0      0    0 %
        2  finger            5      2      2      0    0 %
      sum                   10      4      2      0    0 %
    ");
    assert_eq!(
        chains.iter().map(|chain| chain.links.clone()).collect::<Vec<_>>(),
        [vec![0, 1, 2, 3, 4], vec![0, 1, 5, 6, 7]]
    );
}

#[test]
fn a_figure_without_branches_is_one_chain() {
    insta::assert_snapshot!(check(&figure(&[("bob", "", 1)])), @"
    arm: 1 link, 1 dof, 1 chain
                                       of these in an earlier chain
    chain  end-effector  links   dofs  links   dofs
        1  bob               1      1      0      0    0 %
      sum                    1      1      0      0    0 %
    ");
    let welded = check(&figure(&[("rock", "", 0)]));
    assert_eq!((welded.len(), welded.dofs_with_repeats()), (1, 0));
}
