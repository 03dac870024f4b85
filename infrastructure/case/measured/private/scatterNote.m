% SCATTERNOTE  Says which readings scatter otherwise after the change.
%
% CALL: TEXT = scatterNote (CASE)
%
%   CASE  see newCase
%   TEXT  one sentence without a full stop; '' where scatter has not changed
%
% More scatter is a fault of an instrument, a loose part, a vibration, grains that
% stick and slip; a wrong gain scatters as before.
%
% See also: scatterOfChange

function text = scatterNote (Case)
  said = {};
  for c = 1:numel (Case.conditions)
    for target = Case.targets
      now = target.changed(c);
      if givenField (now, 'scatterP', NaN) < 0.01
        said{end + 1} = sprintf ('%s %.2g times as much in %s (p %s)', ...
                                 target.name, now.scatterRatio, ...
                                 Case.conditions{c}, pText (now.scatterP));
      end
    end
  end
  text = '';
  if ~isempty (said)
    text = ['trials scatter otherwise than in the reference: ', ...
            strjoin(said, ', ')];
  end
end

function text = pText (p)
  text = sprintf ('= %.1g', p);
  if p < 0.001
    text = '< 0.001';
  end
end

%!test
%! changed = @(p) struct ('scatterRatio', 9, 'scatterP', p);
%! Case.targets = struct ('name', {'a', 'b', 'c'}, 'changed', ...
%!                        {changed(1e-5), changed(0.2), changed(0.004)});
%! Case.conditions = {'moist'};
%! assert (scatterNote (Case), ['trials scatter otherwise than in the ' ...
%!         'reference: a 9 times as much in moist (p < 0.001), c 9 times as ' ...
%!         'much in moist (p = 0.004)']);
%! Case.targets = Case.targets(2);
%! assert (scatterNote (Case), '');

% SPDX-License-Identifier: GPL-3.0-only
