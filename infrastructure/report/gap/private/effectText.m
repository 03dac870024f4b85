% EFFECTTEXT  How strong an effect is, in its unit and in words.
%
% CALL: [TEXT, AMOUNT] = effectText (LABEL, UNIT, VALUES [, ISEND])
%
%   LABEL   what the variable is (text)
%   UNIT    text; 'factor' is said as a difference from the model, in percent,
%           'share' in percent
%   VALUES  1 x 3: value, lower and upper end of its interval (NaN: none)
%   ISEND   logical (false): the interval reaches the end of its range
%   TEXT    'tilt of the rig -1.4 deg (-2 to -0.53)'; AMOUNT  without the label

function [text, amount] = effectText (label, unit, values, isEnd)
  values = values(:)';
  switch unit
    case 'factor'
      change = 100 * (values - 1);
      bothWays = change(2) < 0 && change(3) > 0;
      isLess = change(1) < 0;
      if isLess
        change = -change([1, 3, 2]);
      end
      amount = sprintf ('%s %s than modelled', quantity (change(1), '%'), ...
                        merge (isLess, 'smaller', 'larger'));
      if bothWays                        % which way is open
        range = 100 * abs (values(2:3) - 1);
        amount = sprintf ('%s %% smaller to %s %% larger than modelled', ...
                          twoDigits(range(1)), twoDigits(range(2)));
      elseif all (isfinite (change))
        amount = sprintf ('%s (%s to %s)', amount, twoDigits(change(2)), twoDigits(change(3)));
      end
    case 'share'
      amount = quantity (100 * values(1), '%', 100 * values(2:3));
    otherwise
      amount = quantity (values(1), unit, values(2:3));
  end
  if nargin > 3 && isEnd
    amount = regexprep (amount, '\)$', ', the end of its range)');
  end
  text = [label, ' ', amount];
end

%!assert (effectText ('grain size', 'factor', [0.993, 0.5, 2]), ...
%!        'grain size 50 % smaller to 100 % larger than modelled')
%!assert (effectText ('grain size', 'factor', [2, 1.5, 2.5]), ...
%!        'grain size 100 % larger than modelled (50 to 150)')
%!assert (effectText ('energy density', 'J/m3', [4.2e4, 2.6e4, 6e4]), ...
%!        'energy density 42 kJ/m3 (26 to 60)')
%!assert (effectText ('energy density', 'J/m3', [4.2e4, 2.6e4, 6e4], true), ...
%!        'energy density 42 kJ/m3 (26 to 60, the end of its range)')
%!assert (effectText ('the mass', 'factor', [0.923, 0.88, 0.95]), ...
%!        'the mass 7.7 % smaller than modelled (5 to 12)')
%!assert (effectText ('error of the balance', 'share', [0.03, NaN, NaN]), ...
%!        'error of the balance 3 %')

% SPDX-License-Identifier: GPL-3.0-only
