% MISSTEXTS  A miss in words: what it is of, and both numbers.
%
% CALL: [TEXTS, OPEN] = missTexts (M)
%
%   M      element of listMisses
%   TEXTS  1 x 2 cell: 'largest miss: mass', 'simulated 3 g, measured 2 g
%          (allowed 1.9 to 2.1)'. Where runs were made, their mean and what all
%          runs together say stand side by side
%   OPEN   where these two disagree: '3 runs say missed, all runs together say
%          met'; else ''

function [texts, open] = missTexts (m)
  label = 'largest miss: ';
  if m.met == 1 || (isnan (m.met) && m.share < 1)
    label = 'largest deviation: ';
  end
  held = repmat (' (never fitted)', 1, strcmp (m.role, 'holdout'));
  text = simulatedText (m);
  if isfinite (m.measured)
    text = [text, ', measured ', ...
            quantity(m.measured, m.unit, ...
                     m.measured + m.allowed * [-1, 1], 'allowed ')];
  elseif ~isfinite (m.simulated)
    text = sprintf ('%.1f times its noise', 2 * m.share);
  end
  texts = {[label, m.name, held], text};
  open = '';
  if strcmp (m.state, 'open') && m.runs > 0
    says = {'met', 'missed'};
    if m.share > 1                     % of a curve the root mean square
      says = fliplr (says);
    end
    open = sprintf ('%s %s, all runs together say %s', runsSay (m.runs), ...
                    says{2}, says{1});
  end
end

function text = runsSay (n)
  text = sprintf ('%d runs say', n);
  if n == 1
    text = '1 run says';
  end
end

function text = simulatedText (m)
  text = ['simulated ', quantity(m.simulated, m.unit)];
  if m.runs > 0 && isfinite (m.mean) && isfinite (m.simulated)
    runs = 'one run';
    if m.runs > 1
      runs = sprintf ('mean of %d runs', m.runs);
    end
    give = '';
    if isfinite (m.meanSd)
      give = [' +- ', quantity(m.meanSd, m.unit)];
    end
    text = sprintf ('DEM, %s %s%s; all runs together %s', runs, ...
                    quantity (m.mean, m.unit), give, ...
                    quantity (m.simulated, m.unit));
  end
end

%!shared m
%! m = struct ('name', 'force', 'unit', 'N', 'measured', 6, 'simulated', 5.8, ...
%!             'miss', -0.2, 'allowed', 0.3, 'role', 'calibrate', 'met', NaN, ...
%!             'share', 2 / 3, 'state', 'open', 'mean', 5.33, 'meanSd', 0.3, ...
%!             'runs', 3);
%!test
%! [texts, open] = missTexts (m);
%! assert (texts, {'largest deviation: force', ...
%!                 ['DEM, mean of 3 runs 5.33 N +- 300 mN; all runs together ' ...
%!                  '5.8 N, measured 6 N (allowed 5.7 to 6.3)']});
%! assert (open, '3 runs say missed, all runs together say met');
%!test
%! % a curve is met by its root mean square, whatever its worst point says
%! curve = m;
%! [curve.miss, curve.points, curve.share] = deal (-0.5, 11, 0.8);
%! [~, open] = missTexts (curve);
%! assert (open, '3 runs say missed, all runs together say met');
%!test
%! [m.runs, m.state, m.met] = deal (0, '', 1);
%! [texts, open] = missTexts (m);
%! assert (texts{2}, 'simulated 5.8 N, measured 6 N (allowed 5.7 to 6.3)');
%! assert (open, '');
