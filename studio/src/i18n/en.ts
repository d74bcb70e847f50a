// SPDX-License-Identifier: MIT
// The page's words. {name} stands for a value.
export const en = {
  title: 'shigusa studio',
  tagline: 'natural whole-body motion',
  loading: 'Starting the engine …',
  hint: 'Drag the orange ball: the body reaches for it.',
  hintMore: 'Or drag a small blue one: the other hand, the head, a foot.',
  gotIt: 'Got it',
  start: 'Start', startWith: 'To begin with', start_pick: 'Pick up', start_shelf: 'Onto a shelf', start_box: 'Lift a box', start_seated: 'Reach seated',
  start_vrm: 'Your character', start_overhead: 'Overhead',
  viewLabel: 'Three-dimensional view. Arrow keys move the selected goal sideways and up, Page Up and Page Down ahead and back, with Shift further.',
  undo: 'Undo', redo: 'Redo', mirror: 'Mirror', help: 'Help', close: 'Close',
  language: 'Language', theme: 'Theme', themeAuto: 'Theme: auto', themeLight: 'Theme: light', themeDark: 'Theme: dark',
  // search
  searching: 'Searching …', cancel: 'Cancel', searchAgain: 'Search again', best: 'best {score}',
  cancelled: 'The search was stopped.',
  unreachable: 'Out of reach: the closest motion ends {cm} cm short of the goal.',
  unsteady: 'No motion was found that this body could make: {reason}.',
  couldIn: 'It could in {s} s.',
  editMisses: 'With these values the motion ends {cm} cm short of the goal.',
  previewMisses: '{cm} cm out of reach',
  // gallery
  candidates: 'Motions', candidate: 'Motion {n}', chosen: 'chosen', score: 'score', lowerIsBetter: 'lower is better',
  compare: 'Compare', compareWith: 'Compare with motion {n}', comparing: 'compared',
  beside: 'side by side', over: 'overlaid', strip: 'Poses of motion {n} from its beginning to its end',
  fewer: 'Other motions are nearly the same, or much worse.', edited: 'edited', noCandidates: 'Motions will appear here.', noStrip: 'no strip figure',
  // verdict
  possible: 'can be done', strains: 'hard to do', impossible: 'not possible', because: '{verdict}: {reason}', ofFreedom: '{words} ({freedom})', why: 'Why', andMore: '{n} more', takeTime: 'Take {s} s',
  needsStrength: '{joint} at {percent} % of its strength', fallsForward: 'would fall forward: a step is needed', fallsBack: 'would fall backward: a step is needed',
  fallsLeft: 'would fall to the left: a step is needed', fallsRight: 'would fall to the right: a step is needed',
  fallsOver: 'would fall over: the weight is not above the foot that stands', losesBalance: 'would lose its balance: the weight presses {cm} cm outside the feet',
  barelyStands: 'barely keeps its balance: the weight presses {cm} cm outside the feet',
  isIn: '{limb} goes {cm} cm into the {other}', isBeyond: '{joint} goes {deg}° beyond its range', metHard: 'met, but hard to do', showMoment: 'Show the moment',
  knees: 'knees {deg}°', turned: 'turned {deg}°', elbow: 'elbow {deg}°',
  // timeline
  play: 'Play', pause: 'Pause', time: 'Time', speed: 'Speed', loop: 'Loop', overlays: 'Paths and balance', seconds: '{t} s',
  // the View menu
  view: 'View', viewMotion: 'Motion in space', viewGhosts: 'Ghosts', viewGhostsTitle: 'Pale figures at even steps of the motion’s time',
  viewPath: 'Hand’s path by speed', viewSpeed: 'Speed, m/s', viewSpeedLabel: 'Colours of speed: from 0 to {most} metres a second',
  // tabs
  goals: 'Goals', adjust: 'Adjust', criteria: 'Criteria', body: 'Body', plots: 'Plots', take: 'Save',
  panels: 'Panels',
  // goals
  goalsIntro: 'Where hands, feet and head shall be. Metres from the floor between the feet.',
  left: 'left', up: 'up', ahead: 'ahead', load: 'Load', kg: 'kg', turn: 'Give a rotation', rings: 'Turn by rings',
  reachedBy: 'met', short: '{cm} cm short', duration: 'Duration', auto: 'by distance', s: 's',
  method: 'Search', effort: 'Effort', effortQuick: 'quick', effortNormal: 'normal', effortThorough: 'thorough',
  onFloor: '{name} stops at the floor: as it is turned, {m} m is the lowest it can be.',
  remove: 'Remove', seed: 'Other random numbers', seedNumber: 'Seed',
  // adjust
  adjustIntro: 'How the body gets there. The goal stays met while you change it; the mark is what the search found.',
  weightsIntro: 'Stiffness of each joint: the larger, the less it moves beside the others.',
  timing: 'Timing of all motions', ease: 'Ease', gazeLead: 'Gaze lead', notInLayers: 'Not by this search: its layers keep their own time.',
  reset: 'Reset', searchRest: 'Keep these, search the rest', kept: 'Kept by the search: {n}', release: 'Release all',
  lock: 'Lock {name}', noMotion: 'No motion yet.', value: 'Value of {name}', searchValue: 'found by the search: {value}',
  // criteria
  criteriaIntro: 'What counts. Motions are ranked anew at once; search again to find others.',
  penalty: 'penalty {value}', notScored: 'not scored yet: search again', resetWeights: 'As at first',
  paysLeast: 'pays least', paysMost: 'pays most',
  // body
  bodyIntro: 'A built-in body, or drop a character’s file onto the page ({formats}).', builtIn: 'Built-in body',
  characters: 'Characters', statureAndMass: '{cm} cm, {kg} kg', noMesh: 'Its file has no mesh: a mannequin of its size is drawn.',
  moves: 'Moves at {joints} joints, in {ways} ways.',
  stature: 'Stature', mass: 'Mass', sex: 'Strength of', heels: 'Heels may lift', m: 'm',
  openFile: 'Open a file …', understood: 'What was understood',
  doubts: 'Guessed', boneMap: 'Bones', bone: 'Bone', node: 'Node of the file', nothing: '—', apply: 'Apply',
  opening: 'Reading {name} …', dropHere: 'Drop a character’s file ({formats}) or a result',
  // plots
  plotsIntro: 'Point at a plot to move the time.', angles: 'Joint angles, share of the range', torques: 'Torques, share of the strength',
  margin: 'Centre of mass inside the feet, cm', handSpeed: 'Speed of the goal’s hand, m/s', mostUsed: 'most used',
  limit: 'limit', noSupport: 'This body has no feet to stand on.', com: 'centre of mass', cop: 'pressure', sideRight: 'Right', sideLeft: 'Left', sideMiddle: 'Middle',
  plotPicture: 'Save as {format}', plotTable: 'All numbers as {format}',
  // take away
  takeIntro: 'Of the chosen motion, unless something else is said.', animation: 'Animation', figure: 'Figure', again: 'To go on later',
  link: 'Copy a link', linkCopied: 'The link is in the clipboard.', linkShown: 'Copy this link:', openResult: 'Open a result …',
  largeLink: 'This is too much for a link. Save the result instead: it opens to the same.', theLink: 'The link',
  clipName: 'Animation’s name', jointNames: 'Joint names', together: 'All motions in one GLB',
  inPlace: 'In place', inPlaceAbout: 'Leaves out what the hips travel along the floor, for games that move the character themselves.',
  fps: 'Frames a second', fpsOf: 'of {formats}; the others have the motion’s own frames', saved: '{name} is saved.', onlyFor: 'for characters from {formats} files',
  wanted: 'This is a work of “{name}”, whose file is not here. Choose it, or drop it onto the page; until then a body of its measures moves.',
  wantedFirst: 'This is a work of “{name}”, whose file is not here. Choose it, or drop it onto the page, to go on.',
  chooseFile: 'Choose the file …', unknownWanted: '“{file}” is not “{name}” as the work has it.',
  // failures
  badSeed: 'A seed is a whole number from 0 to {most}, not “{value}”.',
  failedFile: '{name} cannot be read.', failed: 'That did not work.', badLink: 'The link is damaged and cannot be read.',
  changedFile: '{name} is not the file that the result describes: it was changed, or is another result’s. Leave it out to open the result without it.',
  unknownFile: '{name}: only characters in {formats} and results in JSON can be opened.',
  noWasm: 'This browser has no WebAssembly, which the engine needs. A current Firefox, Chrome, Edge or Safari has it.',
  noSimd: 'This browser has no WebAssembly SIMD, which the engine needs: Chrome and Edge have it since 91, Firefox since 89, Safari since 16.4.',
  noWebgl: 'This browser shows no WebGL 2, which the picture needs. It may be switched off in its settings.',
  engineFailed: 'The engine did not start.', tooLarge: '{name} is larger than {most} MB.', dismiss: 'Dismiss',
  // help
  helpTitle: 'How to use it',
  help1: 'Drag the orange ball to where the hand shall be. The body follows while you drag; when you let go, five different motions are searched.',
  help2: 'Choose one on the left. Compare it with another, change how it goes under Adjust, and weigh what counts under Criteria.',
  help3: 'Save takes it away as an animation, as a figure or as a link.',
  help4: 'Drag in the empty space to look from elsewhere, with the right button to move the picture, turn the wheel to come nearer.',
  keys: 'Keys',
  keySpace: 'play, pause', keyDigits: 'choose a motion', keyShiftDigits: 'compare with it', keyArrows: 'move the goal, in the view', keyBrackets: 'next goal, in the view',
  keyUndo: 'undo, redo', keyMirror: 'mirror', keyEscape: 'stop the search, close', keyFrame: 'frame by frame', keyGhosts: 'ghosts of the motion', keyPath: 'path coloured by speed', keyHelp: 'this page',
};

export type Key = keyof typeof en;
