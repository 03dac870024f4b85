% MISSTEXTS  A miss in words: what it is of, and both numbers.
%
% CALL: [TEXTS, OPEN] = missTexts (M)
%
%   M      element of listMisses
%   TEXTS  1 x 2 cell: 'largest miss (3.1 times the noise): mass', 'expected 3 g,
%          measured 2 g (allowed 1.9 to 2.1)', in the unit of the measurement.
%          Where runs were made, their mean and what all runs together say stand
%          side by side
%   OPEN   where these two disagree: '3 runs say missed, all runs together say
%          met'; else ''

function [texts, open] = missTexts (m)
  m = inGiven (m);
  isSmall = m.met == 1 || (isnan (m.met) && m.share < 1);
  label = merge (isSmall, 'largest deviation', 'largest miss');
  if isfinite (m.z) && isfinite (m.measured)
    label = sprintf ('%s (%.2g times the noise)', label, abs (m.z));
  end
  held = repmat (' (not fitted)', 1, strcmp (m.role, 'holdout'));
  said = @(x) strtrim (sprintf ('%.4g %s', x, regexprep (m.unit, '^-$', '')));
  text = expectedText (m, said);
  if isfinite (m.measured)
    text = sprintf ('%s, measured %s (allowed %.4g to %.4g)', text, said (m.measured), ...
                    m.measured + m.allowed * [-1, 1]);
  elseif ~isfinite (m.simulated)
    text = sprintf ('%.1f times the noise', 2 * m.share);
  end
  name = m.name;
  if ~isempty (m.label)
    name = sprintf ('%s (%s)', m.label, m.name);
  end
  texts = {[label, ': ', name, held], text};
  open = '';
  if isOpenMiss (m)
    says = {'missed', 'met'};
    isMissed = m.share > 1;            % of a curve the root mean square
    open = sprintf ('%s %s, all runs together say %s', ...
                    countText (m.runs, 'run says', 'runs say'), ...
                    says{1 + isMissed}, says{2 - isMissed});
  end
end

% In the unit that it was measured in.
function m = inGiven (m)
  given = givenField (m, 'given', '');
  factor = unitFactor (m.unit, given);
  if ~isempty (given) && factor > 0
    for name = {'measured', 'simulated', 'miss', 'allowed', 'mean', 'meanSd'}
      m.(name{1}) = m.(name{1}) * factor;
    end
    m.unit = given;
  end
end

function text = expectedText (m, said)
  text = ['expected ', said(m.simulated)];
  if m.runs > 0 && isfinite (m.mean) && isfinite (m.simulated)
    runs = {'one run', sprintf('mean of %d runs', m.runs)};
    sd = repmat (sprintf (' +- %.2g', m.meanSd), 1, isfinite (m.meanSd));
    mean_ = plainNumber (m.mean, noiseKind ('plain', m.mean, m.meanSd));
    text = sprintf ('%s %s%s, expected from all runs %s', runs{1 + (m.runs > 1)}, ...
                    mean_, sd, said (m.simulated));
  end
end

%!shared m
%! m = struct ('name', 'force', 'label', '', 'unit', 'N', 'measured', 6, 'simulated', 5.8, ...
%!             'miss', -0.2, 'allowed', 0.3, 'role', 'calibrate', 'met', NaN, ...
%!             'share', 2 / 3, 'z', -0.5, 'state', 'open', 'mean', 5.33, ...
%!             'meanSd', 0.3, 'runs', 3);
%!test
%! [texts, open] = missTexts (m);
%! assert (texts, {'largest deviation (0.5 times the noise): force', ...
%!                 ['mean of 3 runs 5.33 +- 0.3, expected from all runs ' ...
%!                  '5.8 N, measured 6 N (allowed 5.7 to 6.3)']});
%! assert (open, '3 runs say missed, all runs together say met');
%! texts = missTexts (setfield (m, 'mean', 1e-12));
%! assert (strncmp (texts{2}, 'mean of 3 runs 0 +- 0.3,', 24), texts{2});
%!test
%! % a curve is met by its root mean square, whatever its worst point says
%! curve = m;
%! [curve.miss, curve.points, curve.share] = deal (-0.5, 11, 0.8);
%! [~, open] = missTexts (curve);
%! assert (open, '3 runs say missed, all runs together say met');
%! assert (missTexts (setfield (m, 'given', 'kN')){2}, ...
%!         ['mean of 3 runs 0.00533 +- 0.0003, expected from all runs ' ...
%!          '0.0058 kN, measured 0.006 kN (allowed 0.0057 to 0.0063)']);
%!test
%! [m.runs, m.state, m.met, m.z] = deal (0, '', 1, NaN);
%! [texts, open] = missTexts (m);
%! assert (texts{2}, 'expected 5.8 N, measured 6 N (allowed 5.7 to 6.3)');
%! assert (open, '');
%! m.label = 'force on the lid';
%! assert (missTexts (m){1}, 'largest deviation: force on the lid (force)');

% SPDX-License-Identifier: GPL-3.0-only
