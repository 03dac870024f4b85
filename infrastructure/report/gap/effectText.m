% EFFECTTEXT  How strong an effect is, in its unit and in words.
%
% CALL: [TEXT, AMOUNT] = effectText (LABEL, UNIT, VALUES)
%
%   LABEL   what the variable is (text); 'factor on ...' and 'relative error
%           ...' are said in percent
%   UNIT    text
%   VALUES  1 x 3: value, lower and upper end of its interval (NaN: none)
%   TEXT    'tilt of the rig -1.4 deg (-2 to -0.53)'; AMOUNT  without the label

function [text, amount] = effectText (label, unit, values)
  values = values(:)';
  if strncmp (label, 'factor on ', 10)
    word = 'larger';
    change = 100 * (values - 1);
    if change(1) < 0
      word = 'smaller';
      change = -change([1, 3, 2]);
    end
    label = label(11:end);
    amount = sprintf ('%s %s than modelled%s', quantity (change(1), '%'), ...
                      word, between (change(2:3)));
  elseif strncmp (label, 'relative error', 14)
    amount = quantity (100 * values(1), '%', 100 * values(2:3));
  else
    amount = quantity (values(1), unit, values(2:3));
  end
  text = [label, ' ', amount];
end

function text = between (range)
  text = '';
  if all (isfinite (range))
    text = sprintf (' (%.2g to %.2g)', range);
  end
end

%!assert (effectText ('energy density', 'J/m3', [4.2e4, 2.6e4, 6e4]), ...
%!        'energy density 42 kJ/m3 (26 to 60)')
%!assert (effectText ('factor on the mass', '-', [0.923, 0.88, 0.95]), ...
%!        'the mass 7.7 % smaller than modelled (5 to 12)')
%!assert (effectText ('relative error of the balance', '-', ...
%!                    [0.03, NaN, NaN]), 'relative error of the balance 3 %')
