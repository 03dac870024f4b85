% NAMEDNUMBERS  Reads options such as mu=0.2:0.8 or height=0.0057.
%
% CALL: [NAMES, NUMBERS] = namedNumbers (TEXTS, OPTION, COUNT)
%
%   TEXTS    1 x n cell of texts NAME=NUMBER or, for COUNT 2, NAME=LOW:HIGH
%   OPTION   how the option is called, for the message (text)
%   COUNT    numbers a text: 1 or 2
%   NAMES    1 x n cell of texts
%   NUMBERS  COUNT x n
%
% Errors: DEcalioc:namedNumbers:badValue
%
% See also: commandOptions, newScriptModel

function [names, numbers] = namedNumbers (texts, option, count)
  names = cell (1, numel (texts));
  numbers = zeros (count, numel (texts));
  examples = {'NAME=0.3', 'NAME=0.2:0.8'};
  for k = 1:numel (texts)
    at = find (texts{k} == '=', 1, 'last');
    words = strsplit (texts{k}(at + 1:end), ':');
    values = str2double (words);
    if isempty (at) || at < 2 || numel (values) ~= count || ...
        ~all (isfinite (values))
      error ('DEcalioc:namedNumbers:badValue', ...
             '%s must be given as %s, got %s.', option, ...
             examples{count}, texts{k});
    end
    names{k} = texts{k}(1:at - 1);
    numbers(:, k) = values;
  end
end

%!test
%! [names, numbers] = namedNumbers ({'mu=0.2:0.8', 'r=1e-3:2e-3'}, '--vary', 2);
%! assert (names, {'mu', 'r'});
%! assert (numbers, [0.2, 1e-3; 0.8, 2e-3]);
%!test
%! [names, numbers] = namedNumbers ({'density (kg/m3)=400'}, '--target', 1);
%! assert (names, {'density (kg/m3)'});
%! assert (numbers, 400);
%!assert (size (namedNumbers ({}, '--set', 1)), [1, 0])
%!error id=DEcalioc:namedNumbers:badValue namedNumbers ({'mu=0.2'}, '--vary', 2)
%!error id=DEcalioc:namedNumbers:badValue namedNumbers ({'0.2'}, '--set', 1)
%!error id=DEcalioc:namedNumbers:badValue namedNumbers ({'mu=x'}, '--set', 1)
