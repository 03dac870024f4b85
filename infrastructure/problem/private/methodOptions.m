% METHODOPTIONS  The options of a calibration where its case says nothing.
%
% CALL: O = methodOptions ()
%
%   O  scalar struct: those of the user (docs/inputs.md), then those of the
%      method, each with its reason

function o = methodOptions ()
  o = struct ('sets', 1, 'seed', 1, 'maxFunEvals', 40, 'maxIter', 3, ...
              'tolfun', 0.002, 'replicates', 1, 'WRL', 0, ...
              'method', 'robust', 'infill', 'ahead', ...
              'confidence', 0.95, 'intervals', false);
  % probability that ends the infill: runs that confirm bring the rest
  o.likely = 0.8;
  % so sure should runs at a set make one, and so many are thought ahead for it:
  % with one alone no new set is worth it (infillAhead)
  [o.aimed, o.ahead] = deal (0.9, [1, 2, 4, 8, 16]);
  % below it as many runs at once confirm a set as can go
  o.unsure = 0.9;
  % from here on preferences may choose
  o.even = 0.5;
  % a set less probable than this has turned out wrong
  o.wrong = 0.2;
  % likelier by this must another set be: two fits of the same runs differ less
  o.better = 0.02;
  % standard errors that contradict a tolerance or a surrogate: chance 0.3 %
  o.apart = 3;
  % rounds without a set that meets all before it is said: runs may show a way
  o.conflicts = 2;
  % of the sets that the intervals of the parameters are of, this share must fit
  o.fit = 0.8;
  % of the box: nearer to its wall a parameter stands at it; a wider interval
  % does not identify; how well a parameter measures by itself
  [o.atLimit, o.loose, o.direct] = deal (0.005, 0.5, 0.05);
  % runs for intervals on a curve (closed study curveFewRuns.m), and runs a
  % parameter from which they are believed without (closed study curveCoverage.m)
  [o.intervalRuns, o.jointRuns] = deal (6, 10);
  % of the plan that must succeed: else box or model is at fault
  o.planShare = 2 / 3;
end

%!assert ([methodOptions().maxFunEvals, methodOptions().maxIter], [40, 3])

% SPDX-License-Identifier: GPL-3.0-only
