% MADEBYTEXT  Says which causes may have made the effects, and what to ask.
%
% CALL: TEXT = madeByText (LIST)
%
%   LIST  1 x n struct of weighCauses, or as gap.json has it: label, question,
%         probability, name ('': none of these)
%   TEXT  two sentences; '' where LIST is empty

function text = madeByText (list)
  text = '';
  if isempty (list)
    return
  end
  list = list(:)';
  shown = list([list.probability] >= max (0.05, ...
                                          list(min (3, end)).probability));
  parts = arrayfun (@(c) sprintf ('%s %.2f', c.label, c.probability), shown, ...
                    'UniformOutput', false);
  text = sentence ('cause.madeBy', struct ('list', strjoin (parts, ', ')));
  questions = {shown(~cellfun (@isempty, {shown.name})).question};
  if ~isempty (questions)
    text = [text, ' ', sentence('cause.ask', ...
                                struct ('question', questions{1}))];
  end
end

%!test
%! list = struct ('name', {'moisture', '', 'batch'}, 'label', ...
%!                {'moisture of the grains', 'none of these', 'another batch'}, ...
%!                'question', {'Have the grains become moist?', '', 'b?'}, ...
%!                'probability', {0.8, 0.17, 0.03});
%! assert (madeByText (list), ['Possible origin: moisture of the ' ...
%!         'grains 0.80, none of these 0.17. Ask first: Have the grains ' ...
%!         'become moist?']);
%! assert (madeByText (list(2)), 'Possible origin: none of these 0.17.');
%! assert (madeByText ([]), '');
