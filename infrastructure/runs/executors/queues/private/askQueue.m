% ASKQUEUE  Whether a queue can be asked, and a number of its configuration.
%
% CALL: [NUMBER, FAULT] = askQueue (PROGRAMS, QUESTION, SIGN, PATTERN)
%
%   PROGRAMS  1 x 2 cell, programs that must be on the PATH: that which submits,
%             that which looks
%   QUESTION  command that prints the configuration (text)
%   SIGN      words in its answer that say that this machine is no part of the
%             queue (text)
%   PATTERN   regular expression, the number is its token
%   NUMBER    NaN where the answer does not hold it, or none came
%   FAULT     text, '' where runs can be handed over; a master that does not
%             answer is waited for later

function [number, fault] = askQueue (programs, question, sign, pattern)
  [number, fault] = deal (NaN, '');
  [status, text] = system (sprintf ('command -v %s && command -v %s && timeout 60 %s 2>&1', ...
                                    programs{:}, question));
  look = ['/', programs{2}];
  if isempty (regexp (text, [look, '\s'], 'once'))
    fault = sprintf ('no %s and %s on the PATH', programs{:});
  elseif ~isempty (strfind (text, sign))
    fault = strtrim (regexprep (text, ['^.*?', look, '\n'], '', 'once'));
  end
  found = regexp (text, pattern, 'tokens', 'once');
  if status == 0 && ~isempty (found)
    number = str2double (found{1});
  end
end

%!function [number, fault] = asked (answer)
%!  folder = emptyFolder ();
%!  for name = {'qput', 'qlook'}
%!    writeAtomic (fullfile (folder, name{1}), "#!/bin/sh\n");
%!  end
%!  writeAtomic (fullfile (folder, 'qconf'), ["#!/bin/sh\necho '", answer, "'\n"]);
%!  system (['chmod +x ', folder, '/*']);
%!  before = getenv ('PATH');
%!  back = onCleanup (@() setenv ('PATH', before));
%!  setenv ('PATH', [folder, ':', before]);
%!  [number, fault] = askQueue ({'qput', 'qlook'}, 'qconf', 'no cell', 'most = (\d+)');
%!endfunction
%!test
%! [number, fault] = asked ('most = 75');
%! assert ({number, fault}, {75, ''});
%! [number, fault] = asked ('there is no cell here');
%! assert ({number, fault}, {NaN, 'there is no cell here'});
%! [~, fault] = askQueue ({'qput', 'qlook'}, 'qconf', 'no cell', 'x');
%! assert (fault, 'no qput and qlook on the PATH');

% SPDX-License-Identifier: GPL-3.0-only
