% BLINDANSWER  Diagnoses case folders, as a user would, and reads the answers.
%
% CALL: ANSWERS = blindAnswer (ROOT, FOLDERS, HIDE)
%
%   ROOT     folder of the toolbox whose code answers
%   FOLDERS  1 x n cell of case folders; one with gap/gap.json is not diagnosed
%            again
%   HIDE     folder that the diagnosis cannot see ('': none), by a mount of its
%            own (unshare of util-linux; refused where that is not possible)
%   ANSWERS  1 x n cell: the text of gap/gap.json, '' where there is none
%
% Errors: DEcalioc:blindAnswer:notHidden
%
% See also: blind, blindCases, blindTable

function answers = blindAnswer (root, folders, hide)
  answers = cell (1, numel (folders));
  program = fullfile (root, 'diagnoseGap.m');
  for i = 1:numel (folders)
    file = fullfile (folders{i}, 'gap', 'gap.json');
    if exist (file, 'file') ~= 2
      line = sprintf (['cd %s && nice octave-cli %s > diagnosis.txt 2>&1 ' ...
                       '< /dev/null'], ...
                      shellQuote (folders{i}), shellQuote (program));
      system (hidden (line, hide));
    end
    answers{i} = '';
    if exist (file, 'file') == 2
      answers{i} = fileread (file);
    end
  end
end

function line = hidden (line, hide)
  if isempty (hide)
    return
  end
  cover = sprintf ('mount -t tmpfs none %s && test -z "$(ls -A %s)"', ...
                   shellQuote (hide), shellQuote (hide));
  if system (sprintf ('unshare -m sh -c %s', shellQuote (cover))) ~= 0
    error ('DEcalioc:blindAnswer:notHidden', ...
           ['blindAnswer: the folder %s could not be hidden from the ' ...
            'diagnosis. Run it as root, or move the truth to another ' ...
            'machine and give no folder.'], hide);
  end
  line = sprintf ('unshare -m sh -c %s', ...
                  shellQuote ([cover, ' && { ', line, '; }']));
end
