% COMMANDOPTIONS  Sorts the words of a command line.
%
% CALL: [OPTIONS, WORDS] = commandOptions (ARGS, SPEC)
%
%   ARGS     cell of texts, as typed
%   SPEC     scalar struct, a field an option: 'flag' (--try), 'one' (--model
%            NAME) or 'many' (--vary A --vary B)
%   OPTIONS  scalar struct with the fields of SPEC: logical, text ('' where
%            not given), 1 x n cell of texts
%   WORDS    1 x n cell of the words that belong to no option
%
% Errors: DEcalioc:commandOptions:unknownName, :missingField (of its value)

function [options, words] = commandOptions (args, spec)
  options = spec;
  start = struct ('flag', false, 'one', '', 'many', {{}});
  for name = fieldnames (spec)'
    options.(name{1}) = start.(spec.(name{1}));
  end
  words = cell (1, 0);
  k = 1;
  while k <= numel (args)
    name = regexp (args{k}, '^--([\w-]+)', 'tokens', 'once');
    if isempty (name)
      words{end + 1} = args{k};
    else
      [options, k] = take (options, spec, args, k);
    end
    k = k + 1;
  end
end

function [options, k] = take (options, spec, args, k)
  [name, value] = strtok (args{k}, '=');
  field = strrep (name(3:end), '-', '_');
  if ~isfield (spec, field)
    known = 'This command has none';
    hint = '';
    if ~isempty (fieldnames (spec))
      names = strcat ('--', strrep (fieldnames (spec)', '_', '-'));
      known = ['Known are: ', strjoin(names, ', ')];
      hint = regexprep (checkNearest (name, names), '.$', '? ');
    end
    error ('DEcalioc:commandOptions:unknownName', ...
           ['%s is not an option here. %s%s. decalioc COMMAND --help shows ' ...
            'the call.'], name, hint, known);
  end
  if strcmp (spec.(field), 'flag')
    options.(field) = true;
    return
  end
  if isempty (value)
    k = k + 1;
  end
  if k > numel (args)
    error ('DEcalioc:commandOptions:missingField', ...
           '%s needs a value behind it, got nothing.', name);
  end
  text = [value(2:end), repmat(args{k}, 1, isempty (value))];
  if strcmp (spec.(field), 'many')
    options.(field){end + 1} = text;
  else
    options.(field) = text;
  end
end

%!shared spec
%! spec = struct ('model', 'one', 'vary', 'many', 'no_run', 'flag');
%!test
%! [o, words] = commandOptions ({'a b', '--vary', 'mu=1:2', '--model=X', ...
%!                               '--no-run', '--vary', 'r=0:1', 'c'}, spec);
%! assert (o.model, 'X');
%! assert (o.vary, {'mu=1:2', 'r=0:1'});
%! assert (o.no_run, true);
%! assert (words, {'a b', 'c'});
%!test
%! o = commandOptions ({}, spec);
%! assert ({o.model, o.vary, o.no_run}, {'', {}, false});
%!error id=DEcalioc:commandOptions:unknownName commandOptions ({'--x'}, spec)
%!error <x is not an option here. Known are: --model, --vary, --no-run. decal>
%! commandOptions ({'--x=3'}, spec)
%!error <x is not an option here. This command has none. decalioc COMMAND -->
%! commandOptions ({'--x'}, struct ())
%!error <mdel is not an option here. Did you mean --model\? Known are: --mod>
%! commandOptions ({'--mdel', 'A'}, spec)
%!error id=DEcalioc:commandOptions:missingField ...
%! commandOptions ({'--model'}, spec)

% SPDX-License-Identifier: GPL-3.0-only
