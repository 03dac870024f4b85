% SEEDRANDOM  Starts Octave's random numbers at a seed.
%
% CALL: RESTORE = seedRandom (SEED)
%
%   SEED     integer
%   RESTORE  onCleanup object: when it is cleared, rand, randn and randg go on
%            from where they were
%
% The same case then gives the same calibration to the last digit, whatever
% was done before in the same Octave.

function restore = seedRandom (seed)
  before = {rand('twister'), randn('twister'), randg('twister')};
  restore = onCleanup (@() putBack (before));
  rand ('twister', seed);
  randn ('twister', seed);
  randg ('twister', seed);
end

function putBack (before)
  rand ('twister', before{1});
  randn ('twister', before{2});
  randg ('twister', before{3});
end

%!test
%! rand ('twister', 7);
%! a = rand (1, 2);
%! rand ('twister', 7);
%! b = rand ();
%! restore = seedRandom (3);
%! c = [rand(), randn()];
%! clear restore
%! assert ([b, rand()], a);
%! restore = seedRandom (3);
%! assert ([rand(), randn()], c);

% SPDX-License-Identifier: GPL-3.0-only
