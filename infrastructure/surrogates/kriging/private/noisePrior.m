% NOISEPRIOR  What is known of the noise of a response before its runs.
%
% CALL: [MEAN, SD] = noisePrior (SCATTER, SCALE)
%
%   SCATTER   [] or 1 x 2: sd of a run over earlier packings of one set, in the
%             unit of the response, and how many they were (2 or more)
%   SCALE     of the standardised response
%   MEAN, SD  of the log noise variance of the standardised response, which is
%             taken as normal
%
% Without SCATTER: 0.3 of the spread of a response, with a deviation of 1.6; 32
% responses of stored LIGGGHTS runs have 0.4 and 1.6 (closed study wrongStored.m).
% With it: the variance of so many packings has a deviation of sqrt (2 / (n - 1)),
% and other sets scatter otherwise, by 0.6: the noise of 26 responses of two stores
% of LIGGGHTS runs is that of 8 packings within 0.75 together
% (closed study scatterOfStores.m).

function [m, sd] = noisePrior (scatter, scale)
  m = 2 * log (0.3);
  sd = 1.6;
  if ~isempty (scatter)
    m = 2 * log (scatter(1) / scale);
    sd = sqrt (2 / (scatter(2) - 1) + 0.6^2);
  end
end

%!test
%! [m, sd] = noisePrior ([0.5, 9], 2);
%! assert ([m, sd], [log(1 / 16), sqrt(0.61)], 1e-12);
%! [m, sd] = noisePrior ([], 7);
%! assert ([exp(m / 2), sd], [0.3, 1.6], 1e-12);

% SPDX-License-Identifier: GPL-3.0-only
