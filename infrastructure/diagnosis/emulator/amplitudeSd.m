% AMPLITUDESD  What few runs of an effect leave open of the size of its mark.
%
% CALL: G = amplitudeSd (EFFECTS, PHI)
%
%   EFFECTS  1 x h struct of learnEffect
%   PHI      n x h, strengths
%   G        n x 1, standard deviation of the logarithm of the size; of several
%            effects that of the least known one; 0 from eight runs on
%
% Exponents from 0.3 to 3 are usual: a deviation of 1 in the exponent, and 0.5
% for what else three or four runs do not tell.

function g = amplitudeSd (effects, phi)
  % a strength of 0.02 stands for none: its logarithm would leave everything open
  far = log (max (abs (phi), 0.02) ./ [effects.strongest]);
  % of a pair that of the less known one, as both share one amplitude
  % (predictHypothesis)
  g = max ([effects.unbent] .* sqrt (0.25 + far.^2), [], 2);
end

%!assert (amplitudeSd (struct ('strongest', {1, 1}, 'unbent', {1, 0}), ...
%!                     [1, 0.1; exp(-1), 1]), sqrt ([0.25; 1.25]), 1e-12)

% SPDX-License-Identifier: GPL-3.0-only
