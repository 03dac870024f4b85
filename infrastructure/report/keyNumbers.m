% KEYNUMBERS  The three numbers of a result, with their units.
%
% CALL: NUMBERS = keyNumbers (V, C)
%
%   V, C     see decideCase
%   NUMBERS  1 x n struct label, text: the largest miss, the targets that are
%            met, the missing effect or else the chance that all are met

function numbers = keyNumbers (v, c)
  numbers = struct ('label', {}, 'text', {});
  if ~isempty (v.misses)
    numbers(end + 1) = ofMiss (v.misses(1));
  end
  if v.of > 0
    label = 'targets met';
    if isequal (jsonAt (c, {'runs'}), 0)
      label = 'targets met, on the surrogates alone';
    elseif ~v.usable && v.met == v.of
      label = 'targets within tolerance so far, not surely';
    end
    numbers(end + 1) = struct ('label', label, ...
                               'text', sprintf ('%d of %d', v.met, v.of));
  end
  if ~isempty (v.cause) && ~isempty (v.cause.amount)
    numbers(end + 1) = v.cause.amount;
  elseif ~isempty (jsonAt (c, {'probability'}))
    text = sprintf ('%.0f %%', 100 * c.probability);
    if c.probability > 0.995
      text = '> 99 %';
    end
    numbers(end + 1) = struct ('label', 'chance that all targets are met', ...
                               'text', text);
  end
end

function number = ofMiss (m)
  label = ['largest miss: ', m.name];
  if m.met == 1 || (isnan (m.met) && m.share < 1)
    label = ['largest deviation: ', m.name];
  end
  if strcmp (m.role, 'holdout')
    label = [label, ' (never fitted)'];
  end
  text = ['simulated ', quantity(m.simulated, m.unit)];
  if isfinite (m.measured)
    allowed = quantity (m.measured, m.unit, ...
                        m.measured + m.allowed * [-1, 1]);
    text = sprintf ('%s, measured %s', text, ...
                    strrep (allowed, ' (', ' (allowed '));
  elseif ~isfinite (m.simulated)
    text = sprintf ('%.1f times its noise', 2 * m.share);
  end
  number = struct ('label', label, 'text', text);
end

%!test
%! m = struct ('name', 'h', 'role', 'holdout', 'met', 0, 'unit', 'm', ...
%!             'measured', 0.02, 'simulated', 0.017, 'allowed', 0.001);
%! v = struct ('misses', m, 'of', 3, 'met', 3, 'usable', false, ...
%!             'cause', []);
%! n = keyNumbers (v, struct ('runs', 0, 'probability', 0.71));
%! assert (n(1).label, 'largest miss: h (never fitted)');
%! assert (n(1).text, 'simulated 17 mm, measured 20 mm (allowed 19 to 21)');
%! assert (n(2).label, 'targets met, on the surrogates alone');
%! assert ({n(2:3).text}, {'3 of 3', '71 %'});
%! % a diagnosis without a calibration knows the miss in its noise alone
%! [m.measured, m.simulated, m.met, m.share] = deal (NaN, NaN, NaN, 3.1);
%! v.misses = m;
%! assert (keyNumbers (v, [])(1).text, '6.2 times its noise');
