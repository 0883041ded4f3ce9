// Scenes to begin with: those of the project's own tests, as they stand there.

import bystanders from '../../../fixtures/scenes/parts/bystanders.ron';
import crowd from '../../../fixtures/scenes/crowd.ron';
import cat from '../../../fixtures/scenes/falling_cat.ron';
import fall from '../../../fixtures/scenes/fall.ron';
import fourBar from '../../../fixtures/scenes/four_bar.ron';
import jump from '../../../fixtures/scenes/jump.ron';
import look from '../../../fixtures/scenes/look.ron';
import pendulum from '../../../fixtures/scenes/pendulum.ron';
import sequence from '../../../fixtures/scenes/sequence.ron';
import servos from '../../../fixtures/scenes/servos.ron';
import tower from '../../../fixtures/scenes/tower.ron';
import looseArm from '../../../fixtures/scenes/walk_loose_arm.ron';
import slope from '../../../fixtures/scenes/walk_slope.ron';

export interface Example {
  title: string;
  text: string;
  // What it includes, by name.
  files?: Record<string, string>;
}

export const EXAMPLES: Example[] = [
  { title: 'A pendulum', text: pendulum },
  { title: 'Servos lead four arms', text: servos },
  { title: 'One part after the other', text: sequence },
  { title: 'A crank and a rocker: a closed chain', text: fourBar },
  { title: 'A jumper', text: jump },
  { title: 'A falling cat', text: cat },
  { title: 'A tower comes down', text: tower },
  { title: 'Two who look and reach', text: look },
  { title: 'A walk with a loose arm', text: looseArm },
  { title: 'Up a slope with a stick', text: slope },
  { title: 'A crowd watches a bird', text: crowd, files: { 'parts/bystanders.ron': bystanders } },
  { title: 'Somebody goes limp (long)', text: fall },
];
