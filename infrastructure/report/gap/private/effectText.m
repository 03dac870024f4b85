% EFFECTTEXT  How strong an effect is, in its unit and in words.
%
% CALL: [TEXT, AMOUNT] = effectText (LABEL, UNIT, VALUES)
%
%   LABEL   what the variable is (text)
%   UNIT    text; 'factor' is said as a difference from the model, in percent,
%           'share' in percent
%   VALUES  1 x 3: value, lower and upper end of its interval (NaN: none)
%   TEXT    'tilt of the rig -1.4 deg (-2 to -0.53)'; AMOUNT  without the label

function [text, amount] = effectText (label, unit, values)
  values = values(:)';
  switch unit
    case 'factor'
      change = 100 * (values - 1);
      isLess = change(1) < 0;
      if isLess
        change = -change([1, 3, 2]);
      end
      amount = sprintf ('%s %s than modelled', quantity (change(1), '%'), ...
                        merge (isLess, 'smaller', 'larger'));
      if all (isfinite (change))
        amount = sprintf ('%s (%.2g to %.2g)', amount, change(2:3));
      end
    case 'share'
      amount = quantity (100 * values(1), '%', 100 * values(2:3));
    otherwise
      amount = quantity (values(1), unit, values(2:3));
  end
  text = [label, ' ', amount];
end

%!assert (effectText ('energy density', 'J/m3', [4.2e4, 2.6e4, 6e4]), ...
%!        'energy density 42 kJ/m3 (26 to 60)')
%!assert (effectText ('the mass', 'factor', [0.923, 0.88, 0.95]), ...
%!        'the mass 7.7 % smaller than modelled (5 to 12)')
%!assert (effectText ('error of the balance', 'share', [0.03, NaN, NaN]), ...
%!        'error of the balance 3 %')
